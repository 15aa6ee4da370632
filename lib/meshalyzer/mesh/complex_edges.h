#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <vector>

namespace meshalyzer {

/// Returns one half-edge for each edge of the file's complex, also for an edge that was cut into
/// several border edges.
///
/// @return     Half-edges that have a face, in order of the mesh's edges; for a cut edge the
///             half-edge of its lowest face.
/// @complexity O(#E).
[[nodiscard]] std::vector<HalfedgeHandle> complex_edges(const CutMesh& cut);

}  // namespace meshalyzer
