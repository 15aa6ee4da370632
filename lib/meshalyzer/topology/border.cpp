#include "meshalyzer/topology/border.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/edge_key.h"
#include "meshalyzer/mesh/inner_halfedge.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <cstdint>

namespace meshalyzer {
namespace {

struct BorderEdge {
  /// The smaller file vertex in the upper half, the larger in the lower. No two border edges are
  /// equal.
  std::uint64_t ends = 0;
  HalfedgeHandle halfedge;
};

/// Returns the mesh edges that are parts of edges with several faces, ascending.
std::vector<Index> find_cut_edges(const CutMesh& cut) {
  std::vector<Index> edges;
  for (const CutEdges* kind : {&cut.side.flipped_edges, &cut.side.non_manifold_edges}) {
    for (const HalfedgeHandle h : kind->halfedges) {
      edges.push_back(static_cast<Index>(cut.mesh.edge_handle(h).idx()));
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

std::vector<HalfedgeHandle> find_border_edges(const CutMesh& cut) {
  const TriMesh& mesh = cut.mesh;
  const std::vector<Index> candidates = parallel_filter(
      mesh.n_edges(), [&](Index e) { return mesh.is_boundary(EdgeHandle(static_cast<int>(e))); });
  const std::vector<Index> cut_edges = find_cut_edges(cut);
  std::vector<BorderEdge> borders;
  for (const Index e : candidates) {
    if (std::binary_search(cut_edges.begin(), cut_edges.end(), e)) continue;
    const HalfedgeHandle inner = inner_halfedge(mesh, EdgeHandle(static_cast<int>(e)));
    const auto [a, b] = file_ends(cut, inner);
    borders.push_back({edge_key(a, b), inner});
  }
  std::sort(borders.begin(), borders.end(),
            [](const BorderEdge& a, const BorderEdge& b) { return a.ends < b.ends; });
  std::vector<HalfedgeHandle> halfedges;
  halfedges.reserve(borders.size());
  for (const BorderEdge& border : borders) halfedges.push_back(border.halfedge);
  return halfedges;
}

}  // namespace meshalyzer
