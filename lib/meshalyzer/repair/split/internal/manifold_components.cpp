#include "meshalyzer/repair/split/internal/manifold_components.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace meshalyzer {
namespace {

Index face_of(const CutMesh& cut, HalfedgeHandle h) {
  return static_cast<Index>(cut.mesh.face_handle(h).idx());
}

/// #mesh faces: components numbered in order of their lowest faces.
DisjointSets::Numbers number_components(const CutMesh& cut, const std::vector<EdgeKind>& kinds) {
  DisjointSets components(cut.mesh.n_faces());
  for (const EdgeHandle e : cut.mesh.edges()) {
    if (kinds[static_cast<std::size_t>(e.idx())] != EdgeKind::Inner) continue;
    components.unite(face_of(cut, cut.mesh.halfedge_handle(e, 0)),
                     face_of(cut, cut.mesh.halfedge_handle(e, 1)));
  }
  const CutEdges& flipped = cut.side.flipped_edges;
  for (std::size_t i = 0; i < flipped.size(); ++i) {
    const auto halfedges = flipped[i].halfedges;
    components.unite(face_of(cut, halfedges[0]), face_of(cut, halfedges[1]));
  }
  return components.number_all();
}

}  // namespace

ManifoldComponents find_manifold_components(const CutMesh& cut) {
  const std::vector<EdgeKind> kinds = classify_edges(cut);
  DisjointSets::Numbers number = number_components(cut, kinds);
  const std::size_t count = number.count;
  ManifoldComponents components{.of_face = std::move(number.of), .openness = {}};
  std::vector<double> n_rim(count, 0.0);
  std::vector<double> n_border(count, 0.0);
  for (const EdgeHandle e : cut.mesh.edges()) {
    const EdgeKind kind = kinds[static_cast<std::size_t>(e.idx())];
    if (kind != EdgeKind::Border && kind != EdgeKind::NonManifold) continue;
    const HalfedgeHandle h = cut.mesh.halfedge_handle(e, 0);
    const HalfedgeHandle inner = cut.mesh.is_boundary(h) ? cut.mesh.opposite_halfedge_handle(h) : h;
    const Index component = components.of_face[face_of(cut, inner)];
    n_rim[component] += 1.0;
    if (kind == EdgeKind::Border) n_border[component] += 1.0;
  }
  for (std::size_t i = 0; i < count; ++i) {
    components.openness.push_back(n_border[i] / std::max(1.0, n_rim[i]));
  }
  return components;
}

}  // namespace meshalyzer
