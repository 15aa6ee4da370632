#pragma once

#include "meshalyzer/repair/cut/internal/cut_surface.h"
#include "meshalyzer/repair/passes.h"

namespace meshalyzer {

/// Makes edits of what cutting has made of a mesh: an operation for each part of the surface that
/// changes, as far as parts do not depend on each other. Parts that are unfinished, or that would
/// change what must stay, are refused instead.
///
/// @param patches  What cut_surface() has added.
[[nodiscard]] PassResult cut_edits(const PassInput& input,
                                   std::span<const Edits::AddedFace> patches,
                                   const CutSurface& surface);

/// Makes one operation of all that cutting has made of a mesh, or refuses all of it if a part of it
/// meets an obstacle.
[[nodiscard]] PassResult cut_edits_as_one(const PassInput& input,
                                          std::span<const Edits::AddedFace> patches,
                                          const CutSurface& surface, LostParts lost);

}  // namespace meshalyzer
