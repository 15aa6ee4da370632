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

/// A point of a plane, and the point of a triangle that is closest to it.
struct PlaceNearTriangle {
  Vec3 place;
  Vec3 closest;
};

/// Finds a convex part of a plane all of which is within a distance of a triangle, except for
/// rounding. For a triangle in the plane it is what lies within the distance of its sides, with the
/// rounded corners cut off straight, but for the one towards a given place: that has a tip there.
///
/// @param from  The place, which is to be in the part. It is within the distance.
/// @return      The half-spaces that bound the part, at most eleven; none if there is no such part.
[[nodiscard]] std::vector<HalfSpace> find_near_region(const Corners& triangle,
                                                      const FacePlane& plane, double distance,
                                                      const PlaceNearTriangle& from);

}  // namespace meshalyzer
