#pragma once

#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/holes/internal/hole_loop.h"
#include "meshalyzer/repair/holes/internal/patch_check.h"

namespace meshalyzer {

/// Adds a patch as one operation. Each of its faces is like the face beyond the border edge that
/// the fewest faces lie between.
void add_patch(const PreparedMesh& mesh, const HoleLoop& loop, const Patch& patch, Edits& edits);

}  // namespace meshalyzer
