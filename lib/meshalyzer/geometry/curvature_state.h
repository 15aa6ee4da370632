#pragma once

#include "meshalyzer/geometry/curvature.h"

#include <vector>

namespace meshalyzer {

// Private to the geometry module: what the connectivity alone says of curvature.

/// Tells for each of the file's vertices whether it can have a curvature; never NoArea.
///
/// @return     #file vertices. Where it is Defined, the vertex is one of the mesh's with a closed
/// fan.
/// @complexity O(#V).
[[nodiscard]] std::vector<CurvatureState> curvature_states(const CutMesh& cut);

/// Counts the edges at each of the file's vertices beyond as many as there are faces: 0 where they
/// form closed fans, 1 for each open fan, less where fans have edges in common.
///
/// @return     #file vertices.
/// @complexity O(#V).
[[nodiscard]] std::vector<int> edges_beyond_faces(const CutMesh& cut);

}  // namespace meshalyzer
