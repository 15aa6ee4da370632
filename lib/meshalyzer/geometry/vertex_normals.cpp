#include "meshalyzer/geometry/vertex_normals.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/geometry/face_shape.h"
#include "meshalyzer/mesh/one_ring.h"

#include <cmath>

namespace meshalyzer {
namespace {

/// A sum of weighted unit normals, and of their weights, in units of 4^exponent, which is not 0
/// only for areas.
struct NormalSum {
  Vec3 normal = Vec3::Zero();
  double weight = 0.0;
  int exponent = 0;

  void add(const NormalSum& term) {
    if (term.weight == 0.0) {
      return;
    }
    if (weight == 0.0) {
      *this = term;
    } else if (term.exponent <= exponent) {
      add_scaled(term, exponent);
    } else {
      const NormalSum smaller = *this;
      *this = term;
      add_scaled(smaller, exponent);
    }
  }

 private:
  void add_scaled(const NormalSum& term, int unit) {
    const double factor = term.exponent == unit ? 1.0 : std::ldexp(1.0, 2 * (term.exponent - unit));
    normal += factor * term.normal;
    weight += factor * term.weight;
  }
};

NormalSum weighted(const FaceShape& face, std::size_t corner, NormalWeight weight) {
  if (face.area == 0.0) {
    return {};
  }
  const double amount = weight == NormalWeight::Uniform ? 1.0
                        : weight == NormalWeight::Area  ? face.area
                                                        : face.angle[corner];
  return {.normal = amount * face.normal,
          .weight = amount,
          .exponent = weight == NormalWeight::Area ? face.exponent : 0};
}

/// Sums the normals over the fan of a mesh vertex.
NormalSum sum_round(const TriMesh& mesh, VertexHandle v, const std::vector<FaceShape>& shapes,
                    NormalWeight weight) {
  NormalSum sum;
  for (const HalfedgeHandle h : one_ring_halfedges(mesh, v)) {
    if (!mesh.is_boundary(h)) {
      const auto face = static_cast<std::size_t>(mesh.face_handle(h).idx());
      sum.add(weighted(shapes[face], corner_left_by(mesh, h), weight));
    }
  }
  return sum;
}

}  // namespace

std::vector<Vec3> vertex_normals(const CutMesh& cut, NormalWeight weight) {
  const std::vector<FaceShape> shapes = measure_face_shapes(cut.mesh);
  std::vector<NormalSum> sums(cut.mesh.n_vertices());
  parallel_chunks(sums.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      sums[i] = sum_round(cut.mesh, VertexHandle(static_cast<int>(i)), shapes, weight);
    }
  });
  for (std::size_t i = 0; i < cut.side.copies.size(); ++i) {
    sums[cut.side.copies[i]].add(sums[cut.side.n_file_vertices + i]);
  }
  std::vector<Vec3> vertices(cut.side.n_file_vertices);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const double length = sums[i].normal.stableNorm();
    vertices[i] = length > kNormalsCancel * sums[i].weight ? Vec3(sums[i].normal / length)
                                                           : Vec3(Vec3::Zero());
  }
  return vertices;
}

}  // namespace meshalyzer
