#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <vector>

namespace meshalyzer {

/// Finds the mesh faces that have the same three file vertices as an earlier one, in any order.
///
/// @return     All faces except the lowest on the same vertices, ascending.
/// @complexity O(#E), apart from sorting the faces at each non-manifold edge: duplicates share
///             their edges, so only neighbours are compared.
[[nodiscard]] std::vector<FaceHandle> find_duplicate_faces(const CutMesh& cut);

}  // namespace meshalyzer
