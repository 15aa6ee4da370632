#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <vector>

namespace meshalyzer {

/// One half-edge for each edge of the file's complex, whatever the number of border edges it was
/// cut into.
///
/// @return     Half-edges that have a face, in order of the mesh's edges; of a cut edge the one of
/// its lowest face.
/// @complexity O(#E).
[[nodiscard]] std::vector<HalfedgeHandle> complex_edges(const CutMesh& cut);

}  // namespace meshalyzer
