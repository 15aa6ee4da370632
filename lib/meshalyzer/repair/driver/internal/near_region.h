#pragma once

#include "meshalyzer/repair/driver/internal/convex_piece.h"

#include <vector>

namespace meshalyzer {

/// A plane through a point.
struct FacePlane {
  Vec3 point;
  /// Of length 1.
  Vec3 normal;

  [[nodiscard]] double height(const Vec3& p) const { return (p - point).dot(normal); }
};

/// Finds a convex part of a plane all of which is within a distance of a triangle, except for
/// rounding. For a triangle in the plane it is what lies within the distance of its sides, with the
/// rounded corners cut off straight.
///
/// @param height  The height above the plane of a point of the triangle to which the part is to
///                reach. Its magnitude is less than the distance.
/// @return        The half-spaces that bound the part, at most ten; none if there is no such part.
[[nodiscard]] std::vector<HalfSpace> find_near_region(const Corners& triangle,
                                                      const FacePlane& plane, double distance,
                                                      double height);

}  // namespace meshalyzer
