#include "support/rational_oracle.h"

#include "support/rational_figures.h"

#include <algorithm>

namespace meshalyzer::test {
namespace {

using Vector = RationalVector;

Vector vector(const Vec3& v) {
  return {Rational(v.x()), Rational(v.y()), Rational(v.z())};
}

Vector normal_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  return CGAL::cross_product(vector(b) - vector(a), vector(c) - vector(a));
}

Sign sign_of(const Rational& value) {
  return static_cast<Sign>(CGAL::sign(value));
}

Rational six_volumes(std::span<const Vec3> corners) {
  Rational sum = 0;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    sum += vector(corners[i]) * CGAL::cross_product(vector(corners[i + 1]), vector(corners[i + 2]));
  }
  return sum;
}

}  // namespace

Sign rational_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return sign_of(normal_of(a, b, c) * (vector(d) - vector(a)));
}

Sign rational_orient2d(Axis dropped, const Vec3& a, const Vec3& b, const Vec3& c) {
  return sign_of(normal_of(a, b, c)[static_cast<int>(dropped)]);
}

bool is_rational_normal(const Vec3& normal, const Triangle3& corners, double error) {
  const Vector truth = normal_of(corners[0], corners[1], corners[2]);
  const Rational share(error);
  return (vector(normal) - truth).squared_length() <= share * share * truth.squared_length();
}

bool is_rational_normal_within(const Triangle3& corners, double low, double high) {
  const Vector truth = normal_of(corners[0], corners[1], corners[2]);
  const Rational largest =
      std::max({CGAL::abs(truth.x()), CGAL::abs(truth.y()), CGAL::abs(truth.z())});
  return largest >= Rational(low) && largest <= Rational(high);
}

Sign rational_volume_sign(std::span<const Vec3> corners) {
  return sign_of(six_volumes(corners));
}

double rational_volume(std::span<const Vec3> corners) {
  return CGAL::to_double(six_volumes(corners) / 6);
}

}  // namespace meshalyzer::test
