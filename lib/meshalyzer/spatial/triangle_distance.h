#pragma once

#include "meshalyzer/spatial/triangle_contact.h"

#include <optional>

namespace meshalyzer {

/// A point of a triangle, and how far it is from the point asked for.
struct TrianglePoint {
  Vec3 point;
  /// The distance in the mesh's unit; infinite only where the true distance exceeds the largest
  /// double.
  double distance = 0.0;
};

/// The directions that make an angle of at most a given size with an axis; with an apex, a solid
/// cone without end. Convex, so a triangle has one closest point in it.
struct Cone {
  /// The direction of the axis, of length 1.
  Vec3 axis;
  /// Cosine of the angle between the axis and the side: 0 (a half-space) ... 1, less than 1.
  double cos_half_angle = 0.0;
};

/// Returns the point of a triangle that is closest to `p`.
///
/// With u = 2^-53 and m the distance from `p` to the farthest corner, the distance is off by some
/// u m at most, for any shape: slivers keep their digits, and a triangle of zero area counts as the
/// segment or point that it is. The distance of a corner is exactly 0, as is that of a point of an
/// edge which the arithmetic can tell to be on it. Right for all finite doubles.
///
/// The distance does not depend on which corner comes first, nor on the direction the corners run
/// in, but for its last digits.
[[nodiscard]] TrianglePoint closest_on_triangle(const Corners& t, const Vec3& p);

/// Returns the closest of those points of a triangle that lie in a cone with its apex at `p`.
///
/// The apex is in the cone: on the triangle its distance is 0. Points on the cone's side count as
/// in it, as far as rounding can tell.
///
/// @return Nothing where the triangle lies outside the cone.
[[nodiscard]] std::optional<TrianglePoint> closest_on_triangle(const Corners& t, const Vec3& p,
                                                               const Cone& cone);

}  // namespace meshalyzer
