#include "polynomial_fit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meshalyzer::bench {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// x^2/2, xy, y^2/2, x^3, x^2 y, x y^2, y^3, 1, x, y, of which an option leaves some out.
constexpr Eigen::Index kMonomials = 10;
using Monomials = Eigen::Matrix<double, 1, kMonomials>;

Monomials monomials(double x, double y) {
  return {x * x / 2, x * y, y * y / 2, x * x * x, x * x * y, x * y * y, y * y * y, 1.0, x, y};
}

Monomials along_x(double x, double y) {
  return {x, y, 0.0, 3 * x * x, 2 * x * y, y * y, 0.0, 0.0, 1.0, 0.0};
}

Monomials along_y(double x, double y) {
  return {0.0, x, y, 0.0, x * x, 2 * x * y, 3 * y * y, 0.0, 0.0, 1.0};
}

std::vector<Eigen::Index> columns(const FitOptions& options) {
  std::vector<Eigen::Index> all{0, 1, 2};
  if (options.degree == 3) all.insert(all.end(), {3, 4, 5, 6});
  if (options.constant_and_linear == FitOptions::Low::Fitted) all.insert(all.end(), {7, 8, 9});
  return all;
}

/// The vertices up to so many edges away, without the vertex itself.
std::vector<VertexHandle> neighbourhood(const TriMesh& mesh, VertexHandle v, std::size_t rings) {
  std::vector<VertexHandle> all{v};
  std::size_t begin = 0;
  for (std::size_t ring = 0; ring < rings; ++ring) {
    const std::size_t end = all.size();
    for (std::size_t i = begin; i < end; ++i) {
      for (const VertexHandle w : mesh.vv_range(all[i])) {
        if (std::find(all.begin(), all.end(), w) == all.end()) all.push_back(w);
      }
    }
    begin = end;
  }
  all.erase(all.begin());
  return all;
}

struct Equation {
  Monomials row;
  double value = 0.0;
};

/// In units of `size`.
std::vector<Equation> equations(const TriMesh& mesh, VertexHandle v,
                                const std::vector<Vec3>& normals, double size,
                                const FitOptions& options) {
  const Eigen::Matrix3d frame = frame_of(normals[static_cast<std::size_t>(v.idx())]);
  std::vector<Equation> all;
  for (const VertexHandle w : neighbourhood(mesh, v, options.rings)) {
    const Vec3 p = frame.transpose() * (mesh.point(w) - mesh.point(v)) / size;
    all.push_back({monomials(p.x(), p.y()), p.z()});
    const Vec3 n = frame.transpose() * normals[static_cast<std::size_t>(w.idx())];
    if (options.slopes == FitOptions::Slopes::OfNormals && n.z() > 0.1) {
      all.push_back({along_x(p.x(), p.y()), -n.x() / n.z()});
      all.push_back({along_y(p.x(), p.y()), -n.y() / n.z()});
    }
  }
  if (options.constant_and_linear == FitOptions::Low::Fitted) all.push_back({monomials(0, 0), 0});
  return all;
}

PrincipalEstimate fit(const TriMesh& mesh, VertexHandle v, const std::vector<Vec3>& normals,
                      const FitOptions& options) {
  double size = 0.0;
  for (const EdgeHandle e : mesh.ve_range(v)) {
    size += mesh.calc_edge_length(e) / static_cast<double>(mesh.valence(v));
  }
  const std::vector<Equation> all = equations(mesh, v, normals, size, options);
  const std::vector<Eigen::Index> used = columns(options);
  if (all.size() < used.size()) return {.k1 = kNone, .k2 = kNone};
  const auto n_rows = static_cast<Eigen::Index>(all.size());
  Eigen::MatrixXd matrix(n_rows, static_cast<Eigen::Index>(used.size()));
  Eigen::VectorXd values(n_rows);
  for (Eigen::Index i = 0; i < n_rows; ++i) {
    const Equation& equation = all[static_cast<std::size_t>(i)];
    matrix.row(i) = equation.row(used);
    values[i] = equation.value;
  }
  Monomials found = Monomials::Zero();
  found(used) = matrix.colPivHouseholderQr().solve(values).transpose();
  Eigen::Matrix2d hessian;
  hessian << found[0], found[1], found[1], found[2];
  return curvature_of_graph({found[8], found[9]}, hessian / size,
                            frame_of(normals[static_cast<std::size_t>(v.idx())]));
}

}  // namespace

Eigen::Matrix3d frame_of(const Vec3& normal) {
  Eigen::Matrix3d frame;
  frame.col(0) = normal.unitOrthogonal();
  frame.col(1) = normal.cross(frame.col(0));
  frame.col(2) = normal;
  return frame;
}

PrincipalEstimate curvature_of_graph(const Eigen::Vector2d& slope, const Eigen::Matrix2d& hessian,
                                     const Eigen::Matrix3d& frame) {
  // The graph is where z - f(x, y) is 0: its shape operator is the Hessian of that on the tangent
  // plane, over the length of its gradient.
  const Vec3 gradient(-slope.x(), -slope.y(), 1.0);
  const Eigen::Matrix<double, 3, 2> tangents = frame_of(gradient.normalized()).leftCols<2>();
  const Eigen::Matrix<double, 2, 2> flat = tangents.topRows<2>();
  const Eigen::Matrix2d shape = -flat.transpose() * hessian * flat / gradient.norm();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(shape);
  const Eigen::Matrix<double, 3, 2> directions = frame * tangents * solver.eigenvectors();
  return {solver.eigenvalues()[1], solver.eigenvalues()[0], directions.col(1), directions.col(0)};
}

std::vector<PrincipalEstimate> fit_polynomials(const TriMesh& mesh,
                                               const std::vector<Vec3>& normals,
                                               const FitOptions& options) {
  std::vector<PrincipalEstimate> result;
  for (const VertexHandle v : mesh.vertices()) {
    result.push_back(fit(mesh, v, normals, options));
  }
  return result;
}

}  // namespace meshalyzer::bench
