#include "meshalyzer/defects/internal/faces_at.h"

#include <algorithm>

namespace meshalyzer {

std::vector<VertexHandle> mesh_vertices(const CutMesh& cut, Index vertex) {
  const SideTable& side = cut.side;
  std::vector<VertexHandle> vertices{VertexHandle(static_cast<int>(vertex))};
  const auto [first, last] = std::equal_range(side.copies.begin(), side.copies.end(), vertex);
  for (auto copy = first; copy != last; ++copy) {
    const auto number = static_cast<std::size_t>(copy - side.copies.begin());
    vertices.emplace_back(static_cast<int>(side.n_file_vertices + number));
  }
  return vertices;
}

std::vector<Index> faces_at(const CutMesh& cut, Index vertex) {
  std::vector<Index> faces;
  for (const VertexHandle v : mesh_vertices(cut, vertex)) {
    if (cut.mesh.is_isolated(v)) continue;
    for (const FaceHandle f : cut.mesh.vf_range(v)) faces.push_back(cut.side.face(f));
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace meshalyzer
