#pragma once

#include "meshalyzer/mesh/tri_mesh.h"

namespace meshalyzer {

/// Returns the half-edge itself if it has a face, else its opposite, which then has one.
[[nodiscard]] inline HalfedgeHandle inner_halfedge(const TriMesh& mesh, HalfedgeHandle halfedge) {
  return mesh.is_boundary(halfedge) ? mesh.opposite_halfedge_handle(halfedge) : halfedge;
}

/// Returns a half-edge of an edge that has a face: the first, unless only the second has one.
[[nodiscard]] inline HalfedgeHandle inner_halfedge(const TriMesh& mesh, EdgeHandle edge) {
  return inner_halfedge(mesh, mesh.halfedge_handle(edge, 0));
}

}  // namespace meshalyzer
