#pragma once

#include "meshalyzer/repair/holes/refine_patch.h"

namespace meshalyzer {

/// Moves the new vertices of a patch to where the surface is bent as evenly as it can be: it
/// minimises the bi-Laplacian energy with cotangent weights, the loop and the faces beyond it
/// staying as they are (Botsch et al. 2010, "Polygon Mesh Processing", section 4.3; Liepa 2003).
///
/// @return      Whether there is such a place for each; if not, all stay.
/// @complexity  That of a sparse factorisation of n rows, about O(n^1.5).
bool fair_patch(const PreparedMesh& mesh, const HoleLoop& loop, WorkingPatch& patch);

}  // namespace meshalyzer
