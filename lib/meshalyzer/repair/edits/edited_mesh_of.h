#pragma once

#include "meshalyzer/io/rewrite/edited_mesh.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

namespace meshalyzer {

/// Lists, for a mesh under repair, the records of the input that its elements come from, so that
/// its file can be written.
///
/// @param input  The mesh that was tracked. The result refers to both.
/// @complexity   O(#V + #F).
[[nodiscard]] EditedMesh edited_mesh_of(const TrackedMesh& tracked, const Soup& input);

}  // namespace meshalyzer
