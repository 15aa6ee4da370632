#include "meshalyzer/topology/orientation.h"

#include "meshalyzer/base/disjoint_sets.h"

namespace meshalyzer {

Orientability find_orientability(const CutMesh& cut, const Components& edge_components) {
  Orientability result;
  result.of_component.assign(edge_components.count, 1);
  const CutEdges& flipped = cut.side.flipped_edges;
  if (flipped.size() == 0) return result;

  // Each region p has two nodes: as it is (2 p) and reversed (2 p + 1). A flipped edge demands that
  // one of its two regions be reversed. A region both of whose nodes become one is one-sided.
  const Components regions = find_oriented_regions(cut);
  const auto face_of = [&](HalfedgeHandle h) {
    return static_cast<std::size_t>(cut.mesh.face_handle(h).idx());
  };
  DisjointSets sides(2 * regions.count);
  for (std::size_t i = 0; i < flipped.size(); ++i) {
    const auto pair = flipped[i].halfedges;
    const Index p = regions.of_face[face_of(pair[0])];
    const Index q = regions.of_face[face_of(pair[1])];
    sides.unite(2 * p, 2 * q + 1);
    sides.unite(2 * p + 1, 2 * q);
  }
  for (std::size_t i = 0; i < flipped.size(); ++i) {
    const std::size_t face = face_of(flipped[i].halfedges[0]);
    const Index p = regions.of_face[face];
    if (sides.find(2 * p) != sides.find(2 * p + 1)) continue;
    result.of_component[edge_components.of_face[face]] = 0;
    result.orientable = false;
  }
  return result;
}

}  // namespace meshalyzer
