#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <vector>

namespace meshalyzer {

/// Returns the mesh vertices into which a file vertex was cut: itself, then its copies.
///
/// @complexity O(log #copies + what is returned).
[[nodiscard]] std::vector<VertexHandle> mesh_vertices(const CutMesh& cut, Index vertex);

/// Returns the faces of the complex that use a file vertex, by ascending record.
[[nodiscard]] std::vector<Index> faces_at(const CutMesh& cut, Index vertex);

}  // namespace meshalyzer
