#include "meshalyzer/geometry/principal_curvature.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/geometry/curvature_tensor.h"
#include "meshalyzer/geometry/fitted_normals.h"
#include "meshalyzer/mesh/one_ring.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer {
namespace {

/// If the two curvatures differ by less than this share of the curvature that turns the normal by
/// one radian across the vertex, their directions are only rounding errors.
constexpr double kCancelled = 1e-12;

std::size_t index_of(FaceHandle face) {
  return static_cast<std::size_t>(face.idx());
}

Vec3 unit_or_zero(const Vec3& sum) {
  const double length = sum.stableNorm();
  return length > 0.0 && std::isfinite(length) ? Vec3(sum / length) : Vec3(Vec3::Zero());
}

/// Returns the unit normal, or zero if the faces cancel each other or have no area.
Vec3 normal_of(const FanSums& sums) {
  if (!sums.has_normal()) return Vec3::Zero();
  const Vec3 normal = unit_or_zero(sums.sphere_normal);
  return normal.isZero(0.0) ? unit_or_zero(sums.normal) : normal;
}

std::vector<Vec3> normals_of(const std::vector<FanSums>& sums) {
  std::vector<Vec3> normals(sums.size());
  parallel_chunks(normals.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      normals[i] = normal_of(sums[i]);
    }
  });
  return normals;
}

/// Returns the normals at the corners of a face; a vertex without one gets that of the face.
std::array<Vec3, 3> corner_normals(const TriMesh& mesh, FaceHandle face, const Vec3& face_normal,
                                   const std::vector<Vec3>& normals) {
  const HalfedgeHandle last = mesh.halfedge_handle(face);
  const HalfedgeHandle first = mesh.next_halfedge_handle(last);
  const std::array corners{mesh.to_vertex_handle(last), mesh.to_vertex_handle(first),
                           mesh.to_vertex_handle(mesh.next_halfedge_handle(first))};
  std::array<Vec3, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& normal = normals[static_cast<std::size_t>(corners[i].idx())];
    result[i] = normal.isZero(0.0) ? face_normal : normal;
  }
  return result;
}

std::vector<CurvatureTensor> fit_faces(const TriMesh& mesh, const std::vector<FaceShape>& shapes,
                                       const std::vector<Vec3>& normals) {
  std::vector<CurvatureTensor> tensors(shapes.size());
  parallel_chunks(shapes.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const FaceHandle face(static_cast<int>(i));
      if (shapes[i].area != 0.0) {
        tensors[i] = fit_curvature(scaled_face(mesh, face), shapes[i],
                                   corner_normals(mesh, face, shapes[i].normal, normals));
      }
    }
  });
  return tensors;
}

/// Returns two unit vectors perpendicular to each other and to a unit vector (Duff et al. 2017,
/// "Building an orthonormal basis, revisited").
std::array<Vec3, 2> tangents(const Vec3& n) {
  const double sign = std::copysign(1.0, n.z());
  const double a = -1.0 / (sign + n.z());
  const double b = n.x() * n.y() * a;
  return {Vec3(1.0 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()),
          Vec3(b, sign + n.y() * n.y() * a, -n.y())};
}

/// Returns a tangent of the unit normal `from`, rotated by the shortest rotation that takes `from`
/// to the unit normal `to`.
Vec3 turned(const Vec3& tangent, const Vec3& from, const Vec3& to) {
  const double cosine = from.dot(to);
  return cosine > -1.0 ? Vec3(tangent - tangent.dot(to) / (1.0 + cosine) * (from + to))
                       : Vec3(-tangent);
}

/// Returns the eigenvalues and eigenvectors of [e f; f g] in the axes u and v.
///
/// @param least  Curvatures that differ by no more than this have no directions.
PrincipalCurvature diagonalised(const std::array<double, 3>& efg, const std::array<Vec3, 2>& uv,
                                double least) {
  const auto [e, f, g] = efg;
  const double mean = e / 2 + g / 2;
  const double half = e / 2 - g / 2;
  const double radius = std::hypot(half, f);
  PrincipalCurvature result{.k1 = mean + radius, .k2 = mean - radius};
  if (2 * radius > least) {
    // Of the two formulas for the eigenvector this one has no cancellation.
    const Eigen::Vector2d d = half >= 0.0 ? Eigen::Vector2d(radius + half, f).stableNormalized()
                                          : Eigen::Vector2d(f, radius - half).stableNormalized();
    result.direction1 = (d.x() * uv[0] + d.y() * uv[1]).normalized();
    result.direction2 = (d.x() * uv[1] - d.y() * uv[0]).normalized();
  }
  return result;
}

/// The tensors of the faces, and the data needed to average them at the vertices.
struct Fitted {
  const TriMesh& mesh;
  const std::vector<FaceShape>& shapes;
  const std::vector<CornerShares>& shares;
  const std::vector<CurvatureTensor>& tensors;
};

PrincipalCurvature average(const Fitted& faces, VertexHandle v, const Vec3& normal) {
  const std::array<Vec3, 2> uv = tangents(normal);
  double area = 0.0;
  std::array<double, 3> efg{};
  for (const HalfedgeHandle h : one_ring_halfedges(faces.mesh, v)) {
    if (faces.mesh.is_boundary(h)) {
      continue;
    }
    const std::size_t face = index_of(faces.mesh.face_handle(h));
    const FaceShape& shape = faces.shapes[face];
    const double share = faces.shares[face][corner_left_by(faces.mesh, h)];
    if (share == 0.0) {
      continue;
    }
    area += share * shape.true_area();
    const Vec3 u = turned(uv[0], normal, shape.normal);
    const Vec3 w = turned(uv[1], normal, shape.normal);
    const Vec3 along_u = faces.tensors[face] * u;
    efg[0] += share * along_u.dot(u);
    efg[1] += share * along_u.dot(w);
    efg[2] += share * (faces.tensors[face] * w).dot(w);
  }
  for (double& entry : efg) entry /= area;
  const double most = std::max({std::abs(efg[0]), std::abs(efg[1]), std::abs(efg[2])});
  return diagonalised(efg, uv, kCancelled * (most + 1.0 / std::sqrt(area)));
}

}  // namespace

std::vector<PrincipalCurvature> principal_curvatures(const TriMesh& mesh,
                                                     const std::vector<FaceShape>& shapes,
                                                     const std::vector<FanSums>& sums,
                                                     const std::vector<CornerShares>& mixed) {
  const std::vector<Vec3> normals = fitted_normals(mesh, normals_of(sums));
  const std::vector<CurvatureTensor> tensors = fit_faces(mesh, shapes, normals);
  const Fitted faces{mesh, shapes, mixed, tensors};
  std::vector<PrincipalCurvature> result(mesh.n_vertices());
  parallel_chunks(result.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      result[i] = average(faces, VertexHandle(static_cast<int>(i)), normals[i]);
    }
  });
  return result;
}

}  // namespace meshalyzer
