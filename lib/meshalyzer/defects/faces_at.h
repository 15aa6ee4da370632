#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <vector>

namespace meshalyzer {

// Private to the defects module: what is at a vertex of the file, whatever it was cut into.

/// The mesh vertices that are a file vertex: itself, then its copies.
///
/// @complexity O(log #copies + what is returned).
[[nodiscard]] std::vector<VertexHandle> mesh_vertices(const CutMesh& cut, Index vertex);

/// The file's faces of the complex that use a file vertex, ascending.
[[nodiscard]] std::vector<Index> faces_at(const CutMesh& cut, Index vertex);

}  // namespace meshalyzer
