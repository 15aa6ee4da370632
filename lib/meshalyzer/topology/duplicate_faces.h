#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <vector>

namespace meshalyzer {

/// Finds the mesh faces that have the same three file vertices as an earlier one, in any order.
///
/// @return     All but the lowest of the faces on the same vertices, ascending.
/// @complexity O(#E) but for sorting the faces round each non-manifold edge: two such faces share
///             their edges, so only neighbours are compared.
[[nodiscard]] std::vector<FaceHandle> find_duplicate_faces(const CutMesh& cut);

}  // namespace meshalyzer
