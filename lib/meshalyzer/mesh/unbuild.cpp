#include "meshalyzer/mesh/unbuild.h"

#include "meshalyzer/base/parallel.h"

namespace meshalyzer {

Triangle unbuild_face(const CutMesh& cut, FaceHandle face) {
  const HalfedgeHandle first = cut.mesh.halfedge_handle(face);
  const HalfedgeHandle second = cut.mesh.next_halfedge_handle(first);
  const HalfedgeHandle third = cut.mesh.next_halfedge_handle(second);
  return {cut.side.vertex(cut.mesh.to_vertex_handle(first)),
          cut.side.vertex(cut.mesh.to_vertex_handle(second)),
          cut.side.vertex(cut.mesh.to_vertex_handle(third))};
}

std::vector<Triangle> unbuild(const CutMesh& cut) {
  std::vector<Triangle> triangles(cut.mesh.n_faces());
  parallel_chunks(triangles.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      triangles[i] = unbuild_face(cut, FaceHandle(static_cast<int>(i)));
    }
  });
  return triangles;
}

}  // namespace meshalyzer
