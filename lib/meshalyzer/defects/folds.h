#pragma once

#include "meshalyzer/mesh/tri_mesh.h"

#include <vector>

namespace meshalyzer {

// Private to the defects module.

/// Finds the folds: edges with two consistently oriented faces of non-zero area, the smaller angle
/// between which is at most `max_angle` degrees.
///
/// @return     A half-edge of each, in order of the mesh's edges.
/// @complexity O(#E), a few operations each but for edges that are sharp.
[[nodiscard]] std::vector<HalfedgeHandle> find_folds(const TriMesh& mesh, double max_angle);

}  // namespace meshalyzer
