#include "meshalyzer/repair/holes/internal/existing_edges.h"

#include "meshalyzer/mesh/edge_key.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>

namespace meshalyzer {

ExistingEdges::ExistingEdges(const PreparedMesh& mesh, std::span<const HoleLoop> loops) {
  const CutMesh& cut = mesh.cut();
  std::vector<std::uint8_t> is_on_loop(mesh.soup().n_vertices(), 0);
  for (const HoleLoop& loop : loops) {
    for (const Index v : loop.vertices) is_on_loop[v] = 1;
  }
  for (const EdgeHandle e : cut.mesh.edges()) {
    const auto [a, b] = file_ends(cut, cut.mesh.halfedge_handle(e, 0));
    if (is_on_loop[a] != 0 && is_on_loop[b] != 0) edges_.push_back(edge_key(a, b));
  }
  std::sort(edges_.begin(), edges_.end());
}

bool ExistingEdges::contains(Index a, Index b) const {
  return std::binary_search(edges_.begin(), edges_.end(), edge_key(a, b));
}

}  // namespace meshalyzer
