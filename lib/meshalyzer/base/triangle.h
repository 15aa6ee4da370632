#pragma once

#include "meshalyzer/base/corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace meshalyzer {

/// Returns the normal (b - a) x (c - a) of a triangle in floating point; its length is twice the
/// area. For a triangle that may be a sliver, accurate_normal() has more correct digits.
[[nodiscard]] inline Vec3 normal_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a);
}

[[nodiscard]] inline Vec3 normal_of(const Corners& t) {
  return normal_of(t[0], t[1], t[2]);
}

/// Returns the unit normal of a triangle times its angle at corner k in radians, which is the share
/// of the triangle in the normal of that vertex (see NormalWeight::Angle); zero if the triangle has
/// no area. It is right for any size.
[[nodiscard]] inline Vec3 angle_weighted_normal(const Corners& t, std::size_t k) {
  const Vec3 next = (t[(k + 1) % 3] - t[k]).stableNormalized();
  const Vec3 last = (t[(k + 2) % 3] - t[k]).stableNormalized();
  const Vec3 across = next.cross(last);
  const Vec3 result = std::atan2(across.norm(), next.dot(last)) * across.stableNormalized();
  return result.allFinite() ? result : Vec3(Vec3::Zero());
}

/// Returns the centroid of a triangle whose coordinates are far from overflow.
[[nodiscard]] inline Vec3 centroid_of(const Corners& t) {
  return (t[0] + t[1] + t[2]) / 3.0;
}

/// Returns the centroid of a triangle with any coordinates, whose sum may overflow.
[[nodiscard]] inline Vec3 centroid_without_overflow(const Corners& t) {
  return t[0] / 3 + t[1] / 3 + t[2] / 3;
}

[[nodiscard]] inline Box3 box_of(const Corners& t) {
  Box3 box;
  for (const Vec3& corner : t) box.extend(corner);
  return box;
}

/// Returns the lengths of the edges from corner k to corner k + 1; they overflow only where the
/// true lengths do.
[[nodiscard]] inline std::array<double, 3> side_lengths(const Corners& t) {
  return {(t[1] - t[0]).stableNorm(), (t[2] - t[1]).stableNorm(), (t[0] - t[2]).stableNorm()};
}

[[nodiscard]] inline double longest_side(const Corners& t) {
  const std::array<double, 3> lengths = side_lengths(t);
  return std::max({lengths[0], lengths[1], lengths[2]});
}

/// Returns the two halves of a triangle, cut from the middle of its longest edge to the opposite
/// corner; of edges of equal length the first counts.
[[nodiscard]] inline std::array<Corners, 2> halve_longest_edge(const Corners& t) {
  const std::array<double, 3> squares{(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(),
                                      (t[0] - t[2]).squaredNorm()};
  const auto k =
      static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  const Vec3 middle = (t[k] + t[(k + 1) % 3]) / 2.0;
  return {Corners{t[k], middle, t[(k + 2) % 3]}, Corners{middle, t[(k + 1) % 3], t[(k + 2) % 3]}};
}

/// Multiplies a point by a power of two, which rounds nothing but coordinates that underflow.
[[nodiscard]] inline Vec3 times_power_of_two(const Vec3& p, int exponent) {
  return {std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent)};
}

[[nodiscard]] inline Corners times_power_of_two(const Corners& t, int exponent) {
  return {times_power_of_two(t[0], exponent), times_power_of_two(t[1], exponent),
          times_power_of_two(t[2], exponent)};
}

/// Tells whether an area, or the length of a normal, is so far from overflow and underflow that the
/// figures that follow from it are the same, digit for digit, at any other such scale.
[[nodiscard]] inline bool is_of_usual_scale(double area) {
  return area > 1e-280 && area < 1e280;
}

/// Returns the exponent of a length that is not 0, which is at least 2^exponent and below
/// 2^(exponent + 1). If the length has overflowed, it is the largest exponent of a double.
[[nodiscard]] inline int length_exponent(double length) {
  return std::isfinite(length) ? std::ilogb(length) : std::numeric_limits<double>::max_exponent - 1;
}

/// Returns the exponent of the largest extent of a triangle along an axis.
///
/// @param t  Corners that are not all at one place.
[[nodiscard]] inline int size_exponent(const Corners& t) {
  return length_exponent(box_of(t).sizes().maxCoeff());
}

/// Returns a triangle of the same shape, 2^exponent times smaller.
///
/// Where the exponent is its size_exponent(), neither lengths nor their products overflow, or
/// underflow without need. Axes along which all corners agree do not matter to the shape, so
/// coordinates are zero there; along other axes no coordinate, being a double, is much larger than
/// the triangle.
[[nodiscard]] inline Corners made_smaller(Corners t, int exponent) {
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const bool is_flat = t[0][axis] == t[1][axis] && t[0][axis] == t[2][axis];
    for (Vec3& corner : t) corner[axis] = is_flat ? 0.0 : std::ldexp(corner[axis], -exponent);
  }
  return t;
}

}  // namespace meshalyzer
