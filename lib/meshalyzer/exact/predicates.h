#pragma once

#include "meshalyzer/base/corners.h"

#include <cstdint>
#include <optional>

namespace meshalyzer {

/// A sign: -1, 0 or 1. Signs multiply like the numbers that have them.
using Sign = int;

/// Tells on which side of the plane through a, b, c the point d lies: 1 on the side that the normal
/// (b-a) x (c-a) points to, -1 on the other, 0 in the plane (or when a, b, c are collinear).
///
/// The answer is exact for all finite doubles: the sign of the determinant |b-a, c-a, d-a| over the
/// reals. Exchanging two arguments negates it; orient3d(a,b,c,d) == 0 exactly when the four points
/// are coplanar.
[[nodiscard]] Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Returns orient3d() where the floating-point filter is sure, else nothing. It is about ten times
/// cheaper than the exact answer when the points are coplanar: call it first where another test may
/// settle the question.
[[nodiscard]] std::optional<Sign> orient3d_if_sure(const Vec3& a, const Vec3& b, const Vec3& c,
                                                   const Vec3& d);

/// The coordinate that a projection drops.
enum class Axis : std::uint8_t { X = 0, Y = 1, Z = 2 };

/// Returns the orientation of the triangle a, b, c projected along an axis: 1 counter-clockwise, -1
/// clockwise, 0 collinear, in the frame of the two coordinates left, taken in cyclic order
/// (dropping X leaves (y, z), Y (z, x), Z (x, y)).
///
/// The answer is exact for all finite doubles: the sign of that component of the normal (b-a) x
/// (c-a).
[[nodiscard]] Sign orient2d(Axis dropped, const Vec3& a, const Vec3& b, const Vec3& c);

/// Returns orient2d() where the floating-point filter is sure, else nothing.
[[nodiscard]] std::optional<Sign> orient2d_if_sure(Axis dropped, const Vec3& a, const Vec3& b,
                                                   const Vec3& c);

/// Tells whether three points lie on one line, exactly: a triangle of zero area.
[[nodiscard]] bool are_collinear(const Vec3& a, const Vec3& b, const Vec3& c);

/// Tells the same of the corners of a triangle.
[[nodiscard]] inline bool are_collinear(const Corners& t) {
  return are_collinear(t[0], t[1], t[2]);
}

/// Returns an axis along which the triangle projects to non-zero area: that of the largest
/// projection if the filter can tell.
/// @return Nothing exactly when the points are collinear.
[[nodiscard]] std::optional<Axis> projection_axis(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace meshalyzer
