#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <vector>

namespace meshalyzer {

/// Finds the edges of the complex that have exactly one face.
///
/// Borders of the cut mesh that are cuts (flipped and non-manifold edges) are not among them.
///
/// @return     The inner half-edge (the one that has the face) of each, in order of their two file
///             vertices: by the smaller, then by the larger.
/// @complexity O(#E + #B log #B), #B the number of border edges.
[[nodiscard]] std::vector<HalfedgeHandle> find_border_edges(const CutMesh& cut);

}  // namespace meshalyzer
