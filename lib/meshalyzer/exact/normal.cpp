#include "meshalyzer/exact/normal.h"

#include "meshalyzer/base/triangle.h"

#include <CGAL/Mpzf.h>

namespace meshalyzer {
namespace {

using Exact = CGAL::Mpzf;

double component(const Vec3& u, const Vec3& v, const Vec3& origin, Eigen::Index k) {
  const Eigen::Index i = (k + 1) % 3;
  const Eigen::Index j = (k + 2) % 3;
  const auto difference = [&](const Vec3& p, Eigen::Index axis) {
    return Exact(p[axis]) - Exact(origin[axis]);
  };
  return CGAL::to_double(difference(u, i) * difference(v, j) - difference(u, j) * difference(v, i));
}

}  // namespace

Vec3 accurate_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  Vec3 normal = u.cross(v);
  // Each component is off by at most 4 u |u| |v| (in the largest norm), so it is accurate where the
  // normal is much longer.
  const double scale = u.cwiseAbs().maxCoeff() * v.cwiseAbs().maxCoeff();
  const double length = normal.cwiseAbs().maxCoeff();
  const bool in_range = scale > 1e-290 && scale < 1e290;
  if (length > 2e-6 * scale && in_range) {
    return normal;
  }
  return {component(b, c, a, 0), component(b, c, a, 1), component(b, c, a, 2)};
}

Vec3 accurate_normal(const Corners& t, std::size_t apex) {
  return accurate_normal(t[apex], t[(apex + 1) % 3], t[(apex + 2) % 3]);
}

Vec3 rescaled_normal(const Corners& t) {
  if (t[0] == t[1] && t[0] == t[2]) return Vec3::Zero();
  return accurate_normal(made_smaller(t, size_exponent(t)));
}

Vec3 unit_normal(const Corners& t) {
  return rescaled_normal(t).stableNormalized();
}

}  // namespace meshalyzer
