#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/prepared/prepared_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The quantities that a mesh can be held to.
enum class LimitKind : std::uint8_t {
  MinCornerAngle,
  MaxAspectRatio,
  MinEdgeAngle,
  MaxEdgeAngle,
  MinEdgeLength,
  MaxEdgeLength,
  MinFaces,
  MaxFaces,
  MaxComponents,
};

inline constexpr std::size_t kLimitKinds = 9;

/// Tells which values pass a limit.
enum class LimitSense : std::uint8_t { AtLeast, AtMost };

/// Describes a limit for users.
struct LimitInfo {
  LimitKind kind;
  /// The name of the option, the key in a settings file, and the code of what is found beyond the
  /// limit.
  std::string_view name;
  LimitSense sense;
  /// What is measured: "smallest angle".
  std::string_view quantity;
  /// What stands behind the value, with a blank before; may be empty.
  std::string_view unit;
  /// Says what the option does.
  std::string_view help;
};

/// One row for each limit, in the order of LimitKind.
[[nodiscard]] std::span<const LimitInfo> limit_table();

/// The row of one limit.
[[nodiscard]] const LimitInfo& limit_info(LimitKind kind);

/// Returns the limit that has a name; nothing where none has it.
[[nodiscard]] std::optional<LimitKind> limit_kind(std::string_view name);

/// The limits that a mesh is held to.
class Limits {
 public:
  [[nodiscard]] std::optional<double>& operator[](LimitKind kind) {
    return values_[static_cast<std::size_t>(kind)];
  }
  [[nodiscard]] const std::optional<double>& operator[](LimitKind kind) const {
    return values_[static_cast<std::size_t>(kind)];
  }

 private:
  std::array<std::optional<double>, kLimitKinds> values_;
};

/// An element, or the whole mesh, whose value is beyond a limit.
struct LimitViolation {
  /// File records: the two ends of an edge, else empty.
  std::vector<Index> vertices;
  /// File records: the face, or those at the edge in the half-edge mesh; empty for the whole mesh.
  std::vector<Index> faces;
  std::optional<Vec3> position;
  double value = 0.0;
};

/// Finds what is beyond one limit, the elements in order of the half-edge mesh.
///
/// @complexity O(#F).
[[nodiscard]] std::vector<LimitViolation> find_beyond_limit(const PreparedMesh& mesh,
                                                            LimitKind kind, double limit);

}  // namespace meshalyzer
