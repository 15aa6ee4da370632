#pragma once

#include "meshalyzer/exact/predicates.h"

#include <CGAL/Mpzf.h>
#include <array>

namespace meshalyzer {

/// A point with exact coordinates: a vertex of a mesh, or an intersection of lines and planes
/// through vertices. Its coordinates are fractions with one denominator.
struct ExactPoint {
  /// Coordinate k is numerator[k] / denominator.
  std::array<CGAL::Mpzf, 3> numerator;
  /// Positive.
  CGAL::Mpzf denominator;
  /// The doubles nearest to the coordinates; ties go to even. They depend on the point alone, not
  /// on how it was computed.
  Vec3 rounded = Vec3::Zero();
  /// The difference between the exact point and `rounded`, with a relative error below 2^-50 or an
  /// absolute one of a few of the smallest doubles; it is zero exactly when rounding changed
  /// nothing.
  Vec3 rest = Vec3::Zero();

  /// Tells whether the coordinates are doubles.
  [[nodiscard]] bool is_rounded() const { return rest.isZero(0.0); }
};

/// Returns a point with finite coordinates as an exact point.
[[nodiscard]] ExactPoint exact_point(const Vec3& point);

/// Returns the point with the given coordinates, rounded; the denominator may be of either sign,
/// not zero.
///
/// The coordinates must be within the range of doubles.
[[nodiscard]] ExactPoint exact_point(std::array<CGAL::Mpzf, 3> numerator, CGAL::Mpzf denominator);

/// Compares two points by x, then y, then z: returns -1 where the first one comes first, 0 where
/// they are the same point, else 1.
[[nodiscard]] Sign compare_lexicographically(const ExactPoint& a, const ExactPoint& b);

/// Returns orient2d() of exact points.
[[nodiscard]] Sign orient2d(Axis dropped, const ExactPoint& a, const ExactPoint& b,
                            const ExactPoint& c);

/// Returns orient3d() of three points with double coordinates and one exact point.
[[nodiscard]] Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const ExactPoint& d);

}  // namespace meshalyzer
