#pragma once

#include "meshalyzer/io/rewrite/edited_mesh.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

namespace meshalyzer {

/// Says of a mesh under repair what records of the input its elements come from, for its file to be
/// written.
///
/// @param input  What was tracked. The result refers to both.
/// @complexity   O(#V + #F).
[[nodiscard]] EditedMesh edited_mesh_of(const TrackedMesh& tracked, const Soup& input);

}  // namespace meshalyzer
