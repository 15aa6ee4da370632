#include "meshalyzer/mesh/complex_edges.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/inner_halfedge.h"

#include <cstdint>

namespace meshalyzer {
namespace {

std::size_t edge_of(HalfedgeHandle h) {
  return static_cast<std::size_t>(h.idx()) / 2;
}

/// Marks all mesh edges of each cut edge except the first.
void mark_repeated(const CutEdges& edges, std::vector<std::uint8_t>& repeated) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (const HalfedgeHandle h : edges[i].halfedges.subspan(1)) {
      repeated[edge_of(h)] = 1;
    }
  }
}

}  // namespace

std::vector<HalfedgeHandle> complex_edges(const CutMesh& cut) {
  const TriMesh& mesh = cut.mesh;
  std::vector<std::uint8_t> repeated(mesh.n_edges(), 0);
  mark_repeated(cut.side.non_manifold_edges, repeated);
  mark_repeated(cut.side.flipped_edges, repeated);
  return collect_chunks<HalfedgeHandle>(
      mesh.n_edges(), [&](Chunk chunk, std::vector<HalfedgeHandle>& edges) {
        for (std::size_t e = chunk.begin; e < chunk.end; ++e) {
          if (repeated[e] != 0) continue;
          edges.push_back(inner_halfedge(mesh, EdgeHandle(static_cast<int>(e))));
        }
      });
}

}  // namespace meshalyzer
