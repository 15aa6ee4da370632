#pragma once

#include "meshalyzer/spatial/triangle_contact.h"

#include <optional>

namespace meshalyzer {

/// A point of a triangle, and its distance to the query point.
struct TrianglePoint {
  Vec3 point;
  /// The distance in the mesh's unit; infinite only if the true distance exceeds the largest
  /// double.
  double distance = 0.0;
};

/// The directions whose angle to an axis is at most a given one; with an apex they form an infinite
/// solid cone. It is convex, so a triangle has one closest point in it.
struct Cone {
  /// The direction of the axis, of length 1.
  Vec3 axis;
  /// The cosine of the angle between the axis and the side, from 0 (a half-space) to below 1.
  double cos_half_angle = 0.0;
};

/// Returns the point of a triangle that is closest to `p`.
///
/// With u = 2^-53 and m the distance from `p` to the farthest corner, the distance is off by some u
/// m at most, for any shape: slivers keep their digits, and a triangle of zero area counts as the
/// segment or point that it is. The distance of a corner is exactly 0, as is that of a point that
/// the arithmetic finds to be on an edge. The result is right for all finite doubles.
///
/// The order of the corners changes only the last digits of the distance.
[[nodiscard]] TrianglePoint closest_on_triangle(const Corners& t, const Vec3& p);

/// Returns the distance of `p` from the segment between `a` and `b`, as exact as that from a
/// triangle.
[[nodiscard]] inline double distance_from_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  return closest_on_triangle({a, b, b}, p).distance;
}

/// Returns the closest of those points of a triangle that lie in a cone with its apex at `p`.
///
/// The apex belongs to the cone, so its distance is 0 if it is on the triangle. Points on the side
/// of the cone count as inside, up to rounding.
///
/// @return Nothing if the triangle lies outside the cone.
[[nodiscard]] std::optional<TrianglePoint> closest_on_triangle(const Corners& t, const Vec3& p,
                                                               const Cone& cone);

}  // namespace meshalyzer
