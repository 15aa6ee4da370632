#include "meshalyzer/geometry/fan_sums.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/one_ring.h"

namespace meshalyzer {
namespace {

FanSums sum_fan(const TriMesh& mesh, VertexHandle v, const std::vector<FaceShape>& shapes,
                const std::vector<CornerShares>& shares) {
  FanSums sums;
  const Vec3& apex = mesh.point(v);
  for (const HalfedgeHandle h : one_ring_halfedges(mesh, v)) {
    if (mesh.is_boundary(h)) {
      continue;
    }
    const auto face = static_cast<std::size_t>(mesh.face_handle(h).idx());
    const FaceShape& shape = shapes[face];
    const std::size_t corner = corner_left_by(mesh, h);
    const double area = shape.true_area();
    const Vec3& next = mesh.point(mesh.to_vertex_handle(h));
    const Vec3& previous = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
    sums.angle += shape.angle[corner];
    sums.area += shares[face][corner] * area;
    // The two cotangent terms of a face at a corner are its opposite side, turned by a right angle
    // in its plane. So no cotangent is computed, and that of a sliver does not swamp the others.
    sums.cotangent += shape.normal.cross(previous - next);
    sums.normal += shape.angle[corner] * shape.normal;
    sums.sphere_normal +=
        area / (next - apex).squaredNorm() / (previous - apex).squaredNorm() * shape.normal;
  }
  return sums;
}

}  // namespace

std::vector<FanSums> sum_fans(const TriMesh& mesh, const std::vector<FaceShape>& shapes,
                              const std::vector<CornerShares>& shares) {
  std::vector<FanSums> sums(mesh.n_vertices());
  parallel_chunks(sums.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      sums[i] = sum_fan(mesh, VertexHandle(static_cast<int>(i)), shapes, shares);
    }
  });
  return sums;
}

}  // namespace meshalyzer
