#include "meshalyzer/exact/facing.h"

#include <CGAL/Mpzf.h>
#include <array>
#include <cmath>
#include <cstddef>

namespace meshalyzer {
namespace {

// The determinant |direction, b-a, c-a| has 6 products of three entries. Each undergoes at most 7
// roundings, of u = 2^-53: two differences, two products, a difference, two sums. The factor also
// covers the roundings of the bound itself.
constexpr double kBound = 6 * 8 * 0x1p-53 * 1.01;

// Within these magnitudes nothing overflows, and any underflow is far below the bound.
constexpr double kSmallestMagnitude = 1e-270;
constexpr double kLargestMagnitude = 1e290;

bool is_in_range(double magnitude) {
  return magnitude > kSmallestMagnitude && magnitude < kLargestMagnitude;
}

using Exact = CGAL::Mpzf;

Sign exact_facing(const Vec3& direction, const Vec3& a, const Vec3& b, const Vec3& c) {
  std::array<Exact, 3> u;
  std::array<Exact, 3> v;
  for (Eigen::Index k = 0; k < 3; ++k) {
    u[static_cast<std::size_t>(k)] = Exact(b[k]) - Exact(a[k]);
    v[static_cast<std::size_t>(k)] = Exact(c[k]) - Exact(a[k]);
  }
  const Exact dot = Exact(direction.x()) * (u[1] * v[2] - u[2] * v[1]) +
                    Exact(direction.y()) * (u[2] * v[0] - u[0] * v[2]) +
                    Exact(direction.z()) * (u[0] * v[1] - u[1] * v[0]);
  return static_cast<Sign>(dot.sign());
}

}  // namespace

Sign facing(const Vec3& direction, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const double area = u.cwiseAbs().maxCoeff() * v.cwiseAbs().maxCoeff();
  const double magnitude = area * direction.cwiseAbs().maxCoeff();
  if (is_in_range(area) && is_in_range(magnitude)) {
    const double dot = direction.dot(u.cross(v));
    if (std::abs(dot) > kBound * magnitude) return dot > 0.0 ? 1 : -1;
  }
  return exact_facing(direction, a, b, c);
}

}  // namespace meshalyzer
