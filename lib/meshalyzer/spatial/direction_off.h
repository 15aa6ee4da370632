#pragma once

#include "meshalyzer/base/types.h"

#include <vector>

namespace meshalyzer {

/// A direction in which a point leaves several faces.
struct DirectionOff {
  /// Of length 1.
  Vec3 direction = Vec3::Zero();
  /// The distance from the plane of the face that is left most slowly, for each unit of length
  /// that the point moves. At most 0 if no direction was found that leaves all faces.
  double clearance = 0.0;
};

/// Finds the direction that leaves several faces with the largest clearance. It goes to the point
/// of the convex hull of the normals that is nearest to the origin, which is found as by Gilbert,
/// Johnson and Keerthi (A fast procedure for computing the distance between complex objects in
/// three-dimensional space, 1988).
///
/// @param normals  The normals of the faces, of length 1; at least one.
/// @complexity     O(#normals) for each of a few iterations.
[[nodiscard]] DirectionOff direction_off(const std::vector<Vec3>& normals);

}  // namespace meshalyzer
