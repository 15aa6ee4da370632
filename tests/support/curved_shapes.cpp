#include "support/curved_shapes.h"

#include "meshalyzer/mesh/build.h"
#include "support/constants.h"
#include "support/shapes.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace meshalyzer::shapes {
namespace {

constexpr double kTorusRadius = 2.0;
constexpr double kJitter = 0.25;
constexpr double kNoise = 0.01;
/// Cosine of 20 degrees.
constexpr double kThin = 0.93969262078590838;

const Vec3 kSemiAxes(1.5, 1.0, 0.75);

/// The first and second derivatives of the function whose zeros are a surface.
struct Derivatives {
  Vec3 gradient = Vec3::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
};

/// Returns the derivatives of (sqrt(x^2 + y^2) - R)^2 + z^2 - 1, halved.
Derivatives torus_derivatives(const Vec3& p) {
  const double rho = std::hypot(p.x(), p.y());
  const Vec3 radial(p.x() / rho, p.y() / rho, 0.0);
  const Vec3 around(-radial.y(), radial.x(), 0.0);
  const double out = rho - kTorusRadius;
  Derivatives d;
  d.gradient = out * radial + p.z() * Vec3::UnitZ();
  d.hessian = radial * radial.transpose() + out / rho * around * around.transpose() +
              Vec3::UnitZ() * Vec3::UnitZ().transpose();
  return d;
}

Derivatives derivatives(Surface surface, const Vec3& p) {
  switch (surface) {
    case Surface::Torus:
      return torus_derivatives(p);
    case Surface::Ellipsoid: {
      const Vec3 inverse = kSemiAxes.cwiseAbs2().cwiseInverse();
      return {p.cwiseProduct(inverse), inverse.asDiagonal()};
    }
    case Surface::Cylinder:
      return {Vec3(p.x(), p.y(), 0.0), Vec3(1.0, 1.0, 0.0).asDiagonal()};
    case Surface::Catenoid:
      // The function is x^2 + y^2 - cosh^2 z, halved; cosh^2 z is (1 + cosh 2z) / 2.
      return {Vec3(p.x(), p.y(), -std::sinh(2 * p.z()) / 2),
              Vec3(1.0, 1.0, -std::cosh(2 * p.z())).asDiagonal()};
    case Surface::MonkeySaddle: {
      Derivatives d;
      d.gradient = Vec3(p.y() * p.y() - p.x() * p.x(), 2 * p.x() * p.y(), 1.0);
      d.hessian.topLeftCorner<2, 2>() << -2 * p.x(), 2 * p.y(), 2 * p.y(), 2 * p.x();
      return d;
    }
    case Surface::Sphere:
      break;
  }
  return {p, Eigen::Matrix3d::Identity()};
}

bool is_stretched_sphere(Surface surface) {
  return surface == Surface::Sphere || surface == Surface::Ellipsoid;
}

/// A grid of parameters (u, v) with a step of 1, of which some directions come back to their start.
struct Grid {
  std::size_t nu = 0;
  std::size_t nv = 0;
  bool wraps_u = false;
  bool wraps_v = false;

  [[nodiscard]] std::size_t columns() const { return wraps_u ? nu : nu + 1; }
  [[nodiscard]] std::size_t rows() const { return wraps_v ? nv : nv + 1; }
};

Grid grid_of(Surface surface, std::size_t level) {
  const std::size_t n = std::size_t{1} << level;
  switch (surface) {
    case Surface::Torus:
      return {.nu = 12 * n, .nv = 6 * n, .wraps_u = true, .wraps_v = true};
    case Surface::MonkeySaddle:
      return {.nu = 4 * n, .nv = 4 * n};
    default:
      return {.nu = 12 * n, .nv = 4 * n, .wraps_u = true};
  }
}

/// The point of parameters that go from 0 to 1.
Vec3 point_of(Surface surface, double u, double v) {
  const double c = std::cos(2 * kPi * u);
  const double s = std::sin(2 * kPi * u);
  const double z = 2 * v - 1;
  switch (surface) {
    case Surface::Torus: {
      const double rho = kTorusRadius + std::cos(2 * kPi * v);
      return {rho * c, rho * s, std::sin(2 * kPi * v)};
    }
    case Surface::Catenoid:
      return {std::cosh(z) * c, std::cosh(z) * s, z};
    case Surface::MonkeySaddle: {
      const double x = 2 * u - 1;
      return {x, z, x * x * x / 3 - x * z * z};
    }
    default:
      return {c, s, z};
  }
}

/// In [-1, 1], the same on every platform.
double random_share(std::mt19937& random) {
  return static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) * 2 - 1;
}

/// Moved by up to `jitter` steps in each parameter; ends of the grid stay on it.
Soup grid_surface(Surface surface, const Grid& grid, double jitter, std::mt19937& random) {
  std::vector<Vec3> positions;
  const auto parameter = [&](std::size_t i, std::size_t n, bool wraps) {
    const double by = jitter * random_share(random);
    return (static_cast<double>(i) + (wraps || (i != 0 && i != n) ? by : 0.0)) /
           static_cast<double>(n);
  };
  for (std::size_t j = 0; j < grid.rows(); ++j) {
    for (std::size_t i = 0; i < grid.columns(); ++i) {
      const double u = parameter(i, grid.nu, grid.wraps_u);
      const double v = parameter(j, grid.nv, grid.wraps_v);
      positions.push_back(point_of(surface, u, v));
    }
  }
  const auto at = [&](std::size_t i, std::size_t j) {
    return static_cast<Index>(j % grid.rows() * grid.columns() + i % grid.columns());
  };
  std::vector<Triangle> triangles;
  for (std::size_t j = 0; j < grid.nv; ++j) {
    for (std::size_t i = 0; i < grid.nu; ++i) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return make(std::move(positions), std::move(triangles));
}

Soup stretched_sphere(Surface surface, std::size_t level, double jitter, std::mt19937& random) {
  Soup soup = icosphere(level);
  // The mean edge of the icosahedron, halved at every level, but for the bulge of the sphere.
  const double step = 1.1 / static_cast<double>(std::size_t{1} << level);
  for (Vec3& p : soup.positions) {
    Vec3 by;
    for (double& x : by) x = jitter * step * random_share(random);
    p = (p + by).normalized().eval();
    if (surface == Surface::Ellipsoid) p = p.cwiseProduct(kSemiAxes).eval();
  }
  return soup;
}

/// Tells whether the triangle has no angle below 20 degrees.
bool is_fat(const std::array<Vec3, 3>& p) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 a = (p[(i + 1) % 3] - p[i]).normalized();
    const Vec3 b = (p[(i + 2) % 3] - p[i]).normalized();
    if (a.dot(b) > kThin) return false;
  }
  return true;
}

/// Tells whether the two faces at an edge may be exchanged for the two on its opposite corners.
bool can_flip(const TriMesh& mesh, EdgeHandle e) {
  const HalfedgeHandle h = mesh.halfedge_handle(e, 0);
  const HalfedgeHandle o = mesh.halfedge_handle(e, 1);
  const Vec3& a = mesh.point(mesh.from_vertex_handle(h));
  const Vec3& b = mesh.point(mesh.to_vertex_handle(h));
  const Vec3& c = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
  const Vec3& d = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(o)));
  const Vec3 normal = (b - a).cross(c - a);
  const auto faces_the_same_way = [&](const Vec3& n) {
    return n.dot(normal) > 0.7 * n.norm() * normal.norm();
  };
  return is_fat({a, d, c}) && is_fat({d, b, c}) && faces_the_same_way((d - a).cross(c - a)) &&
         faces_the_same_way((b - d).cross(c - d));
}

/// With about a third of the edges flipped.
void flip_edges(Soup& soup, std::mt19937& random) {
  TriMesh mesh = build(soup).mesh;
  for (int e = 0; e < static_cast<int>(mesh.n_edges()); ++e) {
    const EdgeHandle edge(e);
    if (random() % 3 == 0 && !mesh.is_boundary(edge) && mesh.is_flip_ok(edge) &&
        can_flip(mesh, edge)) {
      mesh.flip(edge);
    }
  }
  for (const FaceHandle f : mesh.faces()) {
    HalfedgeHandle h = mesh.halfedge_handle(f);
    for (Index& corner : soup.triangles[static_cast<std::size_t>(f.idx())]) {
      corner = static_cast<Index>(mesh.from_vertex_handle(h).idx());
      h = mesh.next_halfedge_handle(h);
    }
  }
}

double mean_edge_length(const Soup& soup) {
  double sum = 0.0;
  for (const Triangle& t : soup.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      sum += (soup.positions[t[i]] - soup.positions[t[(i + 1) % 3]]).norm();
    }
  }
  return sum / (3.0 * static_cast<double>(soup.n_faces()));
}

}  // namespace

std::string_view surface_name(Surface surface) {
  constexpr std::array<std::string_view, kSurfaces.size()> names{
      "sphere", "ellipsoid", "torus", "cylinder", "catenoid", "monkey saddle"};
  return names[static_cast<std::size_t>(surface)];
}

std::string_view meshing_name(Meshing meshing) {
  constexpr std::array<std::string_view, kMeshings.size()> names{"regular", "irregular", "noisy"};
  return names[static_cast<std::size_t>(meshing)];
}

TrueCurvature true_curvature(Surface surface, const Vec3& point) {
  // The shape operator is the Hessian on the tangent plane over the length of the gradient.
  const Derivatives d = derivatives(surface, point);
  TrueCurvature truth;
  truth.normal = d.gradient.normalized();
  Eigen::Matrix<double, 3, 2> tangents;
  tangents.col(0) = truth.normal.unitOrthogonal();
  tangents.col(1) = truth.normal.cross(tangents.col(0));
  const Eigen::Matrix2d shape = tangents.transpose() * d.hessian * tangents / d.gradient.norm();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(shape);
  truth.k1 = solver.eigenvalues()[1];
  truth.k2 = solver.eigenvalues()[0];
  truth.gaussian = shape.determinant();
  truth.mean = shape.trace() / 2;
  truth.direction1 = tangents * solver.eigenvectors().col(1);
  truth.direction2 = tangents * solver.eigenvectors().col(0);
  return truth;
}

CurvedShape curved_shape(Surface surface, Meshing meshing, std::size_t level, std::uint32_t seed) {
  std::mt19937 random(seed);
  const double jitter = meshing == Meshing::Regular ? 0.0 : kJitter;
  CurvedShape shape;
  shape.soup = is_stretched_sphere(surface)
                   ? stretched_sphere(surface, level, jitter, random)
                   : grid_surface(surface, grid_of(surface, level), jitter, random);
  if (meshing != Meshing::Regular) flip_edges(shape.soup, random);
  const double noise = meshing == Meshing::Noisy ? kNoise * mean_edge_length(shape.soup) : 0.0;
  for (Vec3& p : shape.soup.positions) {
    shape.truth.push_back(true_curvature(surface, p));
    p += noise * random_share(random) * shape.truth.back().normal;
  }
  return shape;
}

}  // namespace meshalyzer::shapes
