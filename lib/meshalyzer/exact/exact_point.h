#pragma once

#include "meshalyzer/exact/predicates.h"

#include <CGAL/Mpzf.h>
#include <array>

namespace meshalyzer {

/// A point of space, known exactly: a vertex of a mesh, or where lines and planes through vertices
/// meet. Its coordinates are fractions of one denominator.
struct ExactPoint {
  /// Coordinate k is numerator[k] / denominator.
  std::array<CGAL::Mpzf, 3> numerator;
  /// Positive.
  CGAL::Mpzf denominator;
  /// The doubles nearest to the coordinates, to even where two are equally near: a function of the
  /// point alone, not of how it was found.
  Vec3 rounded = Vec3::Zero();
  /// The difference between the exact point and `rounded`, with a relative error below 2^-50; zero
  /// exactly where rounding changed nothing.
  Vec3 rest = Vec3::Zero();

  /// Tells whether the coordinates are doubles.
  [[nodiscard]] bool is_rounded() const { return rest.isZero(0.0); }
};

/// @param point  Finite.
[[nodiscard]] ExactPoint exact_point(const Vec3& point);

/// Returns the point with the given coordinates, rounded; the denominator may be of either sign,
/// not zero.
///
/// The coordinates must be within the range of doubles.
[[nodiscard]] ExactPoint exact_point(std::array<CGAL::Mpzf, 3> numerator, CGAL::Mpzf denominator);

/// Compares two points by x, then y, then z: returns -1 where the first one comes first, 0 where
/// they are the same point, else 1.
[[nodiscard]] Sign compare_lexicographically(const ExactPoint& a, const ExactPoint& b);

/// orient2d() of exact points.
[[nodiscard]] Sign orient2d(Axis dropped, const ExactPoint& a, const ExactPoint& b,
                            const ExactPoint& c);

/// orient3d() of three points that are doubles and one that need not be.
[[nodiscard]] Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const ExactPoint& d);

}  // namespace meshalyzer
