#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <vector>

namespace meshalyzer {

/// Finds the pinched vertices: those whose faces are not one fan, although they are on no
/// non-manifold edge.
///
/// @return     File vertices, ascending, a subset of SideTable::non_manifold_vertices.
/// @complexity O(n log n), n the length of the side table's lists.
[[nodiscard]] std::vector<Index> find_pinched_vertices(const CutMesh& cut);

}  // namespace meshalyzer
