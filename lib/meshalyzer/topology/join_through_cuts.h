#pragma once

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/mesh/side_table.h"

#include <cstddef>

namespace meshalyzer {

/// Joins the mesh faces at each of some edges along which the mesh is cut.
inline void join_through_cuts(const TriMesh& mesh, const CutEdges& edges, DisjointSets& faces) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto halfedges = edges[i].halfedges;
    for (const HalfedgeHandle h : halfedges.subspan(1)) {
      faces.unite(static_cast<Index>(mesh.face_handle(halfedges[0]).idx()),
                  static_cast<Index>(mesh.face_handle(h).idx()));
    }
  }
}

}  // namespace meshalyzer
