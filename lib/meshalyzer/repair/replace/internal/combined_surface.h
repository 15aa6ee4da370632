#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/boolean/combine_solids.h"
#include "meshalyzer/repair/cut/internal/cut_surface.h"
#include "meshalyzer/repair/pass.h"

#include <span>

namespace meshalyzer {

/// Returns the result of a boolean operation on a mesh and on solids that were added to it, with
/// the face of the mesh that each face is a part of, or the nearest one.
///
/// @param origins  #faces of the operands: the face of the mesh that each is, or kNoIndex.
/// @complexity     O(log #F) for each face of an added solid.
[[nodiscard]] CutSurface surface_of_combined(const PassInput& input, const CombinedSolid& solid,
                                             std::span<const Index> origins);

}  // namespace meshalyzer
