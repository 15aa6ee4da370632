#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/prepared/prepared_mesh.h"

#include <vector>

namespace meshalyzer {

/// Components of a mesh that are connected by intersections.
struct BrokenSolid {
  /// Its faces, by index into the soup, ascending.
  std::vector<Index> faces;
  /// Tells whether each of its components bounds a solid, see bounds_solid(), and whether any does.
  bool all_bound_solid = true;
  bool any_bounds_solid = false;
};

/// Finds the faces at which a mesh is not good: those at edges with another number of faces than
/// two or with faces of opposed orientation, at pinched vertices, those that intersect others, and
/// those of zero area.
///
/// @return     The faces, by index into the soup, ascending.
/// @complexity O(#F) and the cost of PreparedMesh::intersecting_pairs().
[[nodiscard]] std::vector<Index> find_broken_faces(const PreparedMesh& mesh);

/// Finds the components that are not closed, not manifold, not consistently oriented, intersect
/// themselves or others, or have faces of zero area, and unites those that intersect each other.
///
/// @return     The broken solids in order of their lowest face.
/// @complexity The cost of PreparedMesh::intersecting_pairs() and bounds_solid().
[[nodiscard]] std::vector<BrokenSolid> find_broken_solids(const PreparedMesh& mesh);

/// Returns the whole mesh as one broken solid, which is without faces if the mesh has none.
[[nodiscard]] BrokenSolid whole_mesh_as_solid(const PreparedMesh& mesh);

}  // namespace meshalyzer
