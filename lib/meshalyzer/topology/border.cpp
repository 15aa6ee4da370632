#include "meshalyzer/topology/border.h"

#include "meshalyzer/base/parallel.h"
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

}  // namespace

std::vector<HalfedgeHandle> find_border_edges(const CutMesh& cut) {
  const TriMesh& mesh = cut.mesh;
  const std::vector<Index> candidates = parallel_filter(
      mesh.n_edges(), [&](Index e) { return mesh.is_boundary(EdgeHandle(static_cast<int>(e))); });
  // Most meshes have no border: these need no kinds.
  if (candidates.empty()) return {};
  const std::vector<EdgeKind> kinds = classify_edges(cut);
  std::vector<BorderEdge> borders;
  for (const Index e : candidates) {
    if (kinds[e] != EdgeKind::Border) continue;
    const HalfedgeHandle first = mesh.halfedge_handle(EdgeHandle(static_cast<int>(e)), 0);
    const HalfedgeHandle inner =
        mesh.is_boundary(first) ? mesh.opposite_halfedge_handle(first) : first;
    const auto [a, b] = file_ends(cut, inner);
    borders.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), inner});
  }
  std::sort(borders.begin(), borders.end(),
            [](const BorderEdge& a, const BorderEdge& b) { return a.ends < b.ends; });
  std::vector<HalfedgeHandle> halfedges;
  halfedges.reserve(borders.size());
  for (const BorderEdge& border : borders) halfedges.push_back(border.halfedge);
  return halfedges;
}

}  // namespace meshalyzer
