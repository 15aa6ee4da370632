#include "meshalyzer/geometry/vertex_normals.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/geometry/face_measures.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer {
namespace {

/// A sum this much shorter than the angles that went into it has no digits left.
constexpr double kCancelled = 1e-12;

/// A sum of weighted unit normals, and of their weights.
struct NormalSum {
  Vec3 normal = Vec3::Zero();
  double weight = 0.0;
};

/// Of a face; zero where it has no area.
Vec3 unit_normal(std::array<Vec3, 3> p) {
  const double size =
      std::max((p[1] - p[0]).cwiseAbs().maxCoeff(), (p[2] - p[0]).cwiseAbs().maxCoeff());
  if (!(size > 1e-100 && size < 1e100)) {
    // Near 1 in size, so that the product neither overflows nor underflows.
    const int exponent = size == 0.0 ? 0 : std::isfinite(size) ? std::ilogb(size) : 1023;
    for (Vec3& corner : p) {
      corner = corner.unaryExpr([&](double x) { return std::ldexp(x, -exponent); }).eval();
    }
  }
  return accurate_normal(p[0], p[1], p[2]).stableNormalized();
}

/// Between two directions, in radians, accurate for all angles.
double angle_between(const Vec3& a, const Vec3& b) {
  const Vec3 u = a.stableNormalized();
  const Vec3 v = b.stableNormalized();
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

std::vector<Vec3> face_normals(const TriMesh& mesh) {
  std::vector<Vec3> normals(mesh.n_faces());
  parallel_chunks(normals.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      normals[i] = unit_normal(face_corners(mesh, FaceHandle(static_cast<int>(i))));
    }
  });
  return normals;
}

/// Over the one fan of a mesh vertex.
NormalSum sum_round(const TriMesh& mesh, VertexHandle v, const std::vector<Vec3>& normals) {
  NormalSum sum;
  if (mesh.is_isolated(v)) {
    return sum;
  }
  const Vec3& apex = mesh.point(v);
  for (const HalfedgeHandle h : mesh.voh_range(v)) {
    const FaceHandle face = mesh.face_handle(h);
    if (!face.is_valid()) {
      continue;
    }
    const Vec3& normal = normals[static_cast<std::size_t>(face.idx())];
    if (!normal.isZero(0.0)) {
      const HalfedgeHandle next = mesh.next_halfedge_handle(h);
      const double angle = angle_between(mesh.point(mesh.to_vertex_handle(h)) - apex,
                                         mesh.point(mesh.to_vertex_handle(next)) - apex);
      sum.normal += angle * normal;
      sum.weight += angle;
    }
  }
  return sum;
}

}  // namespace

std::vector<Vec3> vertex_normals(const CutMesh& cut) {
  const std::vector<Vec3> normals = face_normals(cut.mesh);
  std::vector<NormalSum> sums(cut.mesh.n_vertices());
  parallel_chunks(sums.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      sums[i] = sum_round(cut.mesh, VertexHandle(static_cast<int>(i)), normals);
    }
  });
  for (std::size_t i = 0; i < cut.side.copies.size(); ++i) {
    const NormalSum& copy = sums[cut.side.n_file_vertices + i];
    sums[cut.side.copies[i]].normal += copy.normal;
    sums[cut.side.copies[i]].weight += copy.weight;
  }
  std::vector<Vec3> vertices(cut.side.n_file_vertices);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const double length = sums[i].normal.norm();
    vertices[i] =
        length > kCancelled * sums[i].weight ? Vec3(sums[i].normal / length) : Vec3(Vec3::Zero());
  }
  return vertices;
}

}  // namespace meshalyzer
