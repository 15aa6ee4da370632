#include "meshalyzer/exact/meet.h"

#include <cstddef>
#include <utility>

namespace meshalyzer {
namespace {

using Exact = CGAL::Mpzf;
using ExactVec3 = std::array<Exact, 3>;

ExactVec3 difference(const Vec3& p, const Vec3& q) {
  return {Exact(p.x()) - Exact(q.x()), Exact(p.y()) - Exact(q.y()), Exact(p.z()) - Exact(q.z())};
}

ExactVec3 cross(const ExactVec3& u, const ExactVec3& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

Exact dot(const ExactVec3& u, const ExactVec3& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

ExactVec3 normal(const PlanePoints& plane) {
  return cross(difference(plane[1], plane[0]), difference(plane[2], plane[0]));
}

/// Returns the point p + t (q - p) at which the linear function with the given values at p and q is
/// zero.
ExactPoint zero_on_line(const LinePoints& line, const Exact& at_p, const Exact& at_q) {
  Exact denominator = at_p - at_q;
  ExactVec3 numerator = difference(line[1], line[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    numerator[k] = at_p * numerator[k] + Exact(line[0][static_cast<Eigen::Index>(k)]) * denominator;
  }
  return exact_point(std::move(numerator), std::move(denominator));
}

}  // namespace

ExactPoint meet(const LinePoints& line, const PlanePoints& plane) {
  const ExactVec3 n = normal(plane);
  return zero_on_line(line, dot(n, difference(line[0], plane[0])),
                      dot(n, difference(line[1], plane[0])));
}

ExactPoint meet(const LinePoints& p, const LinePoints& q, Axis dropped) {
  const auto k = static_cast<std::size_t>(dropped);
  const std::size_t i = (k + 1) % 3;
  const std::size_t j = (k + 2) % 3;
  const ExactVec3 along = difference(q[1], q[0]);
  const auto side = [&](const Vec3& point) {
    const ExactVec3 to = difference(point, q[0]);
    return along[i] * to[j] - along[j] * to[i];
  };
  return zero_on_line(p, side(p[0]), side(p[1]));
}

ExactPoint meet(const PlanePoints& p, const PlanePoints& q, const PlanePoints& r) {
  const ExactVec3 n = normal(p);
  const ExactVec3 u = normal(q);
  const ExactVec3 v = normal(r);
  // Relative to a point of p, the intersection x satisfies n x = 0, u x = a, v x = b.
  const Vec3& origin = p[0];
  const Exact a = dot(u, difference(q[0], origin));
  const Exact b = dot(v, difference(r[0], origin));
  const ExactVec3 vn = cross(v, n);
  const ExactVec3 nu = cross(n, u);
  Exact denominator = dot(u, vn);
  ExactVec3 numerator;
  for (std::size_t k = 0; k < 3; ++k) {
    numerator[k] =
        a * vn[k] + b * nu[k] + Exact(origin[static_cast<Eigen::Index>(k)]) * denominator;
  }
  return exact_point(std::move(numerator), std::move(denominator));
}

}  // namespace meshalyzer
