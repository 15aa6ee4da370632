#include "meshalyzer/defects/internal/faces_at.h"

#include <algorithm>

namespace meshalyzer {

std::vector<Index> faces_at(const CutMesh& cut, Index vertex) {
  std::vector<Index> faces;
  for (const VertexHandle v : cut.side.mesh_vertices(vertex)) {
    if (cut.mesh.is_isolated(v)) continue;
    for (const FaceHandle f : cut.mesh.vf_range(v)) faces.push_back(cut.side.face(f));
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace meshalyzer
