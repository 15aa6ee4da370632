#pragma once

#include "meshalyzer/base/types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// No corners: those of a face that is gone.
inline constexpr Triangle kNoTriangle = {kNoIndex, kNoIndex, kNoIndex};

/// A small change of a WorkingMesh, and what it relies on.
struct MendStep {
  struct NewCorners {
    Index face;
    /// kNoTriangle: the face goes.
    Triangle corners;
  };
  struct NewFace {
    Triangle corners;
    Index like;
  };
  struct Move {
    Index vertex;
    Vec3 to;
  };
  std::vector<NewCorners> changed;
  std::vector<NewFace> added;
  std::optional<Move> moved;
  /// Pairs of vertices of which it counts that they are joined, or are not; beside the edges of the
  /// faces it changes.
  std::vector<std::array<Index, 2>> read_edges;
  /// Vertices of which it counts what kind they are.
  std::vector<Index> read_vertices;
};

/// What became of an attempt to mend something; of several, the last in this order is told.
enum class MendOutcome : std::uint8_t {
  /// No rule applies.
  Hopeless,
  Topology,
  Fixed,
  GroupBorder,
  TooFar,
  MakesThin,
  TurnsOver,
  Possible,
};

/// "collapsing it would ..."
[[nodiscard]] std::string_view mend_reason(MendOutcome outcome);

/// A step that mends something, or why there is none.
struct MendAttempt {
  MendOutcome outcome = MendOutcome::Hopeless;
  MendStep step = {};
  /// Tells how far the surface would be from what it was, about.
  double deviation = 0.0;

  [[nodiscard]] bool is_possible() const { return outcome == MendOutcome::Possible; }
};

/// Returns the better of two attempts: one that is possible, and of two the one that deviates less,
/// else the first.
[[nodiscard]] const MendAttempt& better(const MendAttempt& a, const MendAttempt& b);

}  // namespace meshalyzer
