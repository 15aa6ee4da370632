#include "support/distance_oracle.h"

#include "support/rational_figures.h"

#include <algorithm>

namespace meshalyzer::test {
namespace {

using Vector = RationalVector;

Vector between(const Vec3& from, const Vec3& to) {
  return rational_point(to) - rational_point(from);
}

/// From the origin to the segment a b.
Rational squared_to_segment(const Vector& a, const Vector& b) {
  const Vector along = b - a;
  const Rational at = -(a * along);
  if (at <= 0) return a.squared_length();
  if (at >= along.squared_length()) return b.squared_length();
  return (a + along * (at / along.squared_length())).squared_length();
}

/// Tells whether the origin is inside the prism on the triangle.
bool is_in_prism(const std::array<Vector, 3>& t, const Vector& normal) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (CGAL::cross_product(t[i], t[(i + 1) % 3]) * normal < 0) return false;
  }
  return true;
}

Rational squared_distance(const std::array<Vector, 3>& t) {
  const Vector normal = CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
  if (normal.squared_length() != 0 && is_in_prism(t, normal)) {
    const Rational height = normal * t[0];
    return height * height / normal.squared_length();
  }
  return std::min({squared_to_segment(t[0], t[1]), squared_to_segment(t[1], t[2]),
                   squared_to_segment(t[2], t[0])});
}

}  // namespace

bool is_rational_distance(double distance, const std::array<Vec3, 3>& corners, const Vec3& point,
                          double error) {
  const Rational truth = squared_distance(
      {between(point, corners[0]), between(point, corners[1]), between(point, corners[2])});
  const Rational low = std::max(Rational(0), Rational(distance) - Rational(error));
  const Rational high = Rational(distance) + Rational(error);
  return low * low <= truth && truth <= high * high;
}

}  // namespace meshalyzer::test
