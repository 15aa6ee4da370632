#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/prepared/prepared_mesh.h"

#include <vector>

namespace meshalyzer {

/// Components of a mesh that hang together because they intersect.
struct BrokenSolid {
  /// Its faces, by index into the soup, ascending.
  std::vector<Index> faces;
  /// Whether each of its components bounds a solid, see bounds_solid().
  bool bounds_solid = true;
};

/// Finds the components that are not closed, not manifold, not consistently oriented, intersect
/// themselves or others, or have faces of zero area, and unites those that intersect each other.
///
/// @return     In order of their lowest face.
/// @complexity As PreparedMesh::intersecting_pairs() and bounds_solid().
[[nodiscard]] std::vector<BrokenSolid> find_broken_solids(const PreparedMesh& mesh);

}  // namespace meshalyzer
