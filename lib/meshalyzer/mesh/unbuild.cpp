#include "meshalyzer/mesh/unbuild.h"

namespace meshalyzer {

std::vector<Triangle> unbuild(const CutMesh& cut) {
  std::vector<Triangle> triangles;
  triangles.reserve(cut.mesh.n_faces());
  for (const FaceHandle face : cut.mesh.faces()) {
    const HalfedgeHandle first = cut.mesh.halfedge_handle(face);
    const HalfedgeHandle second = cut.mesh.next_halfedge_handle(first);
    const HalfedgeHandle third = cut.mesh.next_halfedge_handle(second);
    triangles.push_back({cut.side.vertex(cut.mesh.to_vertex_handle(first)),
                         cut.side.vertex(cut.mesh.to_vertex_handle(second)),
                         cut.side.vertex(cut.mesh.to_vertex_handle(third))});
  }
  return triangles;
}

}  // namespace meshalyzer
