#pragma once

#include "meshalyzer/repair/split/internal/pair_round_edge.h"

#include <span>
#include <vector>

namespace meshalyzer {

// Private to pair_round_edge().

/// The position of a face in the order round an edge.
struct FaceByAngle {
  /// Its index in the list given.
  Index face = 0;
  /// Radians, 0 to 2 pi, never less than that of the one before. This is an estimate for choices
  /// between equally valid results; the order itself is exact.
  double angle = 0.0;
};

/// The faces at an edge, by angle.
struct FacesByAngle {
  /// The faces in counter-clockwise order as seen from b.
  std::vector<FaceByAngle> order;
  /// The faces whose apex is collinear with the edge, in the order given.
  std::vector<Index> without_angle;
};

/// Sorts the faces at an edge from a to b by their angle round it.
[[nodiscard]] FacesByAngle sort_by_angle(const Vec3& a, const Vec3& b,
                                         std::span<const FaceAtEdge> faces);

}  // namespace meshalyzer
