#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <vector>

namespace meshalyzer {

/// Glues a cut mesh together again: the triangles of the file's complex, by file vertex.
///
/// @return The triangles in face order; each starts at an arbitrary corner but keeps its
///         orientation.
/// @complexity O(#F).
[[nodiscard]] std::vector<Triangle> unbuild(const CutMesh& cut);

/// Returns the triangle of one mesh face, as unbuild() returns it.
[[nodiscard]] Triangle unbuild_face(const CutMesh& cut, FaceHandle face);

}  // namespace meshalyzer
