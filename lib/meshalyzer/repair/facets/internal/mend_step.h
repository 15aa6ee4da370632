#pragma once

#include "meshalyzer/base/types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// A small change of a WorkingMesh, and the facts that it relies on.
struct MendStep {
  struct NewCorners {
    Index face;
    /// The new corners; kNoTriangle removes the face.
    Triangle corners;
  };
  struct NewFace {
    Triangle corners;
    Index prototype;
  };
  struct Move {
    Index vertex;
    Vec3 to;
  };
  /// A copy of a vertex at another position. The mesh numbers it as its next vertex.
  struct NewVertex {
    Index copy_of;
    Vec3 position;
  };
  std::vector<NewCorners> changed;
  std::vector<NewFace> added;
  std::optional<Move> moved;
  std::optional<NewVertex> added_vertex;
  /// Pairs of vertices for which the step relies on an edge, or on none, between them; beside the
  /// edges of the faces it changes.
  std::vector<std::array<Index, 2>> read_edges;
  /// Vertices for which the step relies on their kind.
  std::vector<Index> read_vertices;
};

/// The outcome of an attempt to mend something. Of several attempts, the last in this order is
/// reported.
enum class MendOutcome : std::uint8_t {
  /// No rule applies.
  Hopeless,
  Topology,
  Fixed,
  GroupBorder,
  TooFar,
  MakesThin,
  TurnsOver,
  Intersects,
  Possible,
};

/// The sentence for logs: "collapsing it would ..."
[[nodiscard]] std::string_view mend_reason(MendOutcome outcome);

/// A step that mends something, or the reason why there is none.
struct MendAttempt {
  MendOutcome outcome = MendOutcome::Hopeless;
  MendStep step = {};
  /// The approximate distance by which the step would move the surface.
  double deviation = 0.0;

  [[nodiscard]] bool is_possible() const { return outcome == MendOutcome::Possible; }
};

/// Returns the better of two attempts: the one that is possible; if both are, the one that deviates
/// less; else the first.
[[nodiscard]] const MendAttempt& better(const MendAttempt& a, const MendAttempt& b);

}  // namespace meshalyzer
