#include "meshalyzer/geometry/curvature_tensor.h"

#include <algorithm>

namespace meshalyzer {
namespace {

/// A face in its own plane: the corners at (0, 0), (1, 0) and (x, height) in units of its longest
/// side.
struct PlaneFace {
  /// The corner of the face that is at (0, 0).
  std::size_t origin = 0;
  double length = 0.0;
  double x = 0.0;
  double height = 0.0;
  Vec3 u = Vec3::Zero();
  Vec3 v = Vec3::Zero();
};

PlaneFace lay_down(const Corners& p, const FaceShape& shape) {
  const std::array length2{(p[1] - p[0]).squaredNorm(), (p[2] - p[1]).squaredNorm(),
                           (p[0] - p[2]).squaredNorm()};
  const auto i =
      static_cast<std::size_t>(std::max_element(length2.begin(), length2.end()) - length2.begin());
  PlaneFace plane{.origin = i, .length = std::sqrt(length2[i])};
  plane.u = (p[(i + 1) % 3] - p[i]) / plane.length;
  plane.v = shape.normal.cross(plane.u);
  plane.x = (p[(i + 2) % 3] - p[i]).dot(plane.u) / plane.length;
  plane.height = 2 * shape.area / length2[i];
  return plane;
}

/// The second fundamental form [e f; f g] in the axes u, v of a face, with g multiplied by the
/// height.
struct Form {
  double e = 0.0;
  double f = 0.0;
  double g_height = 0.0;
};

/// Returns the least-squares solution of  e u + f v = p,  f u + g v = q  over the three sides (u,
/// v) of a face, along which the normal turns by (p, q).
///
/// With w = v / height = 0, 1, -1 and G = g height for unknown, the normal equations are
///     | a    h b      0 |          | sum u p             |
///     | h b  a + c h² b | (e f G) = | sum u q + h sum w p |
///     | 0    b        c |          | sum w q             |
/// where a = sum u², b = sum u w, c = sum w² = 2. Since a c - b² = 3, the matrix has the
/// determinant 3 (a + 2 h²) and is well-conditioned for every height h, which the one of e, f, g is
/// not.
Form fit(const PlaneFace& plane, const std::array<Vec3, 3>& turn) {
  const double h = plane.height;
  const std::array u{1.0, plane.x - 1.0, -plane.x};
  double up = 0.0;
  double uq = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    up += u[i] * turn[i].dot(plane.u);
    uq += u[i] * turn[i].dot(plane.v);
  }
  const double wp = (turn[1] - turn[2]).dot(plane.u);
  const double wq = (turn[1] - turn[2]).dot(plane.v);
  const double a = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
  const double b = u[1] - u[2];
  const double mid = uq + h * wp;
  const double determinant = 3 * (a + 2 * h * h);
  return {.e = ((3 + 4 * h * h) * up - 2 * h * b * mid + h * b * b * wq) / determinant,
          .f = (-2 * h * b * up + 2 * a * mid - a * b * wq) / determinant,
          .g_height = (h * b * b * up - a * b * mid + (a * a + 3 * h * h) * wq) / determinant};
}

}  // namespace

CurvatureTensor fit_curvature(const ScaledFace& face, const FaceShape& shape,
                              const std::array<Vec3, 3>& normals) {
  const PlaneFace plane = lay_down(face.corner, shape);
  const Vec3& n0 = normals[plane.origin];
  const Vec3& n1 = normals[(plane.origin + 1) % 3];
  const Vec3& n2 = normals[(plane.origin + 2) % 3];
  const Form form = fit(plane, {n1 - n0, n2 - n1, n0 - n2});
  // Half the length is the area divided by length and height: the factor that remains of e, f, g in
  // units of 1 / length.
  double unit = plane.length / 2;
  if (face.exponent != 0) unit = std::ldexp(unit, face.exponent);
  const double e = unit * form.e * plane.height;
  const double f = unit * form.f * plane.height;
  const double g = unit * form.g_height;
  const Vec3 along_u = e * plane.u + f * plane.v;
  const Vec3 along_v = f * plane.u + g * plane.v;
  const auto entry = [&](Eigen::Index i, Eigen::Index j) {
    return along_u[i] * plane.u[j] + along_v[i] * plane.v[j];
  };
  return {entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
}

}  // namespace meshalyzer
