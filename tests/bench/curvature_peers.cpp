#include "curvature_peers.h"

#include "polynomial_fit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace meshalyzer::bench {
namespace {

constexpr double kPi = std::numbers::pi;

std::size_t index(VertexHandle v) {
  return static_cast<std::size_t>(v.idx());
}

std::array<VertexHandle, 3> corners(const TriMesh& mesh, FaceHandle f) {
  const HalfedgeHandle h = mesh.halfedge_handle(f);
  const HalfedgeHandle next = mesh.next_halfedge_handle(h);
  return {mesh.from_vertex_handle(h), mesh.to_vertex_handle(h), mesh.to_vertex_handle(next)};
}

/// Returns vertex normals by Max 1999.
std::vector<Vec3> vertex_normals(const TriMesh& mesh) {
  std::vector<Vec3> normals(mesh.n_vertices(), Vec3::Zero());
  for (const FaceHandle f : mesh.faces()) {
    const auto corner = corners(mesh, f);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = mesh.point(corner[(i + 1) % 3]) - mesh.point(corner[i]);
      const Vec3 b = mesh.point(corner[(i + 2) % 3]) - mesh.point(corner[i]);
      normals[index(corner[i])] += a.cross(b) / (a.squaredNorm() * b.squaredNorm());
    }
  }
  for (Vec3& normal : normals) normal.normalize();
  return normals;
}

/// A face seen from one of its corners.
struct Corner {
  Vec3 next;
  Vec3 previous;
  double cot_here = 0.0;
  double cot_next = 0.0;
  double cot_previous = 0.0;
  double area = 0.0;
};

Corner corner_at(const Vec3& here, const Vec3& next, const Vec3& previous) {
  const double twice_area = (next - here).cross(previous - here).norm();
  return {.next = next - here,
          .previous = previous - here,
          .cot_here = (next - here).dot(previous - here) / twice_area,
          .cot_next = (previous - next).dot(here - next) / twice_area,
          .cot_previous = (here - previous).dot(next - previous) / twice_area,
          .area = twice_area / 2};
}

/// The part of a face that is closest to its corner, or of an obtuse face half or a quarter.
double mixed_area(const Corner& c) {
  if (c.cot_here < 0) return c.area / 2;
  if (c.cot_next < 0 || c.cot_previous < 0) return c.area / 4;
  return (c.next.squaredNorm() * c.cot_previous + c.previous.squaredNorm() * c.cot_next) / 8;
}

std::vector<PrincipalEstimate> meyer(const TriMesh& mesh) {
  const std::vector<Vec3> normals = vertex_normals(mesh);
  const std::size_t n = mesh.n_vertices();
  std::vector<double> defect(n, 2 * kPi);
  std::vector<double> area(n, 0.0);
  std::vector<Vec3> cotangent(n, Vec3::Zero());
  for (const FaceHandle f : mesh.faces()) {
    const auto corner = corners(mesh, f);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t v = index(corner[i]);
      const Corner c = corner_at(mesh.point(corner[i]), mesh.point(corner[(i + 1) % 3]),
                                 mesh.point(corner[(i + 2) % 3]));
      defect[v] -= std::atan2(1.0, c.cot_here);
      area[v] += mixed_area(c);
      cotangent[v] -= c.cot_previous * c.next + c.cot_next * c.previous;
    }
  }
  std::vector<PrincipalEstimate> result(n);
  for (std::size_t v = 0; v < n; ++v) {
    const double mean =
        std::copysign(cotangent[v].norm(), cotangent[v].dot(normals[v])) / (4 * area[v]);
    const double root = std::sqrt(std::max(0.0, mean * mean - defect[v] / area[v]));
    result[v].k1 = mean + root;
    result[v].k2 = mean - root;
  }
  return result;
}

/// Returns the estimate of a normal curvature a x^2 + 2 b x y + c y^2 in the frame of a vertex.
PrincipalEstimate from_form(double a, double b, double c, const Eigen::Matrix3d& frame) {
  Eigen::Matrix2d hessian;
  hessian << -a, -b, -b, -c;
  return curvature_of_graph(Eigen::Vector2d::Zero(), hessian, frame);
}

/// Averages the normal curvatures of the edges, weighted by the areas of their faces.
PrincipalEstimate taubin_at(const TriMesh& mesh, VertexHandle v, const Vec3& normal) {
  const Eigen::Matrix3d frame = frame_of(normal);
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  double weights = 0.0;
  for (const HalfedgeHandle h : mesh.voh_range(v)) {
    const Vec3 edge = mesh.point(mesh.to_vertex_handle(h)) - mesh.point(v);
    const Eigen::Vector2d tangent = (frame.leftCols<2>().transpose() * edge).normalized();
    const double curvature = -2 * normal.dot(edge) / edge.squaredNorm();
    const HalfedgeHandle o = mesh.opposite_halfedge_handle(h);
    const double weight = (mesh.is_boundary(h) ? 0.0 : mesh.calc_sector_area(h)) +
                          (mesh.is_boundary(o) ? 0.0 : mesh.calc_sector_area(o));
    sum += weight * curvature * tangent * tangent.transpose();
    weights += weight;
  }
  sum /= weights;
  // Its eigenvalues are (3 k1 + k2) / 8 and (k1 + 3 k2) / 8, for edges in all directions alike.
  PrincipalEstimate result = from_form(sum(0, 0), sum(0, 1), sum(1, 1), frame);
  const double k1 = 3 * result.k1 - result.k2;
  const double k2 = 3 * result.k2 - result.k1;
  result.k1 = k1;
  result.k2 = k2;
  return result;
}

std::vector<PrincipalEstimate> taubin(const TriMesh& mesh) {
  const std::vector<Vec3> normals = vertex_normals(mesh);
  std::vector<PrincipalEstimate> result;
  for (const VertexHandle v : mesh.vertices()) {
    result.push_back(taubin_at(mesh, v, normals[index(v)]));
  }
  return result;
}

/// The form (a, b, c) in the tangents x and y of a face that best tells how normals turn along its
/// edges.
Vec3 face_form(const std::array<Vec3, 3>& point, const std::array<Vec3, 3>& normal,
               const Eigen::Matrix3d& frame) {
  Eigen::Matrix<double, 6, 3> matrix;
  Eigen::Matrix<double, 6, 1> values;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 edge = frame.transpose() * (point[(i + 1) % 3] - point[i]);
    const Vec3 turn = frame.transpose() * (normal[(i + 1) % 3] - normal[i]);
    const auto row = static_cast<Eigen::Index>(2 * i);
    matrix.row(row) << edge.x(), edge.y(), 0.0;
    matrix.row(row + 1) << 0.0, edge.x(), edge.y();
    values.segment<2>(row) = turn.head<2>();
  }
  return matrix.colPivHouseholderQr().solve(values);
}

std::vector<PrincipalEstimate> rusinkiewicz(const TriMesh& mesh) {
  const std::vector<Vec3> normals = vertex_normals(mesh);
  std::vector<Eigen::Matrix2d> sums(mesh.n_vertices(), Eigen::Matrix2d::Zero());
  std::vector<double> areas(mesh.n_vertices(), 0.0);
  for (const FaceHandle f : mesh.faces()) {
    const auto corner = corners(mesh, f);
    std::array<Vec3, 3> p;
    std::array<Vec3, 3> n;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = mesh.point(corner[i]);
      n[i] = normals[index(corner[i])];
    }
    const Eigen::Matrix3d frame = frame_of((p[1] - p[0]).cross(p[2] - p[0]).normalized());
    const Vec3 form = face_form(p, n, frame);
    Eigen::Matrix2d tensor;
    tensor << form[0], form[1], form[1], form[2];
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Matrix3d turn =
          Eigen::Quaterniond::FromTwoVectors(n[i], frame.col(2)).toRotationMatrix();
      const Eigen::Matrix2d to_face =
          (frame.transpose() * turn * frame_of(n[i])).topLeftCorner<2, 2>();
      const double share = mixed_area(corner_at(p[i], p[(i + 1) % 3], p[(i + 2) % 3]));
      sums[index(corner[i])] += share * to_face.transpose() * tensor * to_face;
      areas[index(corner[i])] += share;
    }
  }
  std::vector<PrincipalEstimate> result;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const Eigen::Matrix2d form = sums[v] / areas[v];
    result.push_back(from_form(form(0, 0), form(0, 1), form(1, 1), frame_of(normals[v])));
  }
  return result;
}

std::vector<PrincipalEstimate> hamann(const TriMesh& mesh) {
  return fit_polynomials(mesh, vertex_normals(mesh), {});
}

std::vector<PrincipalEstimate> goldfeather(const TriMesh& mesh) {
  return fit_polynomials(mesh, vertex_normals(mesh),
                         {.degree = 3, .slopes = FitOptions::Slopes::OfNormals});
}

template <int kDegree>
std::vector<PrincipalEstimate> cazals(const TriMesh& mesh) {
  return fit_polynomials(
      mesh, vertex_normals(mesh),
      {.rings = 2, .degree = kDegree, .constant_and_linear = FitOptions::Low::Fitted});
}

}  // namespace

std::span<const CurvatureMethod> published_methods() {
  static constexpr std::array<CurvatureMethod, 7> all{
      CurvatureMethod{"Meyer et al. 2003", meyer},
      CurvatureMethod{"Taubin 1995", taubin},
      CurvatureMethod{"Rusinkiewicz 2004", rusinkiewicz},
      CurvatureMethod{"Hamann 1993", hamann},
      CurvatureMethod{"Goldfeather, Interrante 2004", goldfeather},
      CurvatureMethod{"Cazals, Pouget 2005, degree 2", cazals<2>},
      CurvatureMethod{"Cazals, Pouget 2005, degree 3", cazals<3>}};
  return all;
}

}  // namespace meshalyzer::bench
