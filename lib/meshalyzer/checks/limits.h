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

/// The direction of a limit: which values pass it.
enum class LimitSense : std::uint8_t { AtLeast, AtMost };

/// Describes a limit for users.
struct LimitInfo {
  LimitKind kind;
  /// The name of the option, the key in a settings file, and the code of what is found beyond the
  /// limit.
  std::string_view name;
  LimitSense sense;
  /// The measured quantity: "smallest angle".
  std::string_view quantity;
  /// The unit after the value, with a leading blank; may be empty.
  std::string_view unit;
  /// Says what the option does.
  std::string_view help;
};

/// Returns one row for each limit, in the order of LimitKind.
[[nodiscard]] std::span<const LimitInfo> limit_table();

/// Returns the row of one limit.
[[nodiscard]] const LimitInfo& limit_info(LimitKind kind);

/// Returns the limit with the given name, or nothing if no limit has it.
[[nodiscard]] std::optional<LimitKind> limit_kind(std::string_view name);

/// The limits against which a mesh is checked. They may be infinite, but are not NaN.
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
  /// The file records of the two ends of an edge, else empty.
  std::vector<Index> vertices;
  /// The file records of the face, or of the faces at the edge in the half-edge mesh; empty for the
  /// whole mesh.
  std::vector<Index> faces;
  std::optional<Vec3> position;
  double value = 0.0;
};

/// Finds the elements beyond one limit, in order of the half-edge mesh.
///
/// @param limit  May be infinite.
/// @throws InvalidArgument  if it is NaN, or a position of the mesh is not finite.
/// @complexity O(#F).
[[nodiscard]] std::vector<LimitViolation> find_beyond_limit(const PreparedMesh& mesh,
                                                            LimitKind kind, double limit);

}  // namespace meshalyzer
