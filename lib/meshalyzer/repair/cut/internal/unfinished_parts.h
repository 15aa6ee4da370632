#pragma once

#include "meshalyzer/repair/cut/internal/cut_surface.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// Tells which faces change together with one that could not be cut to the end.
///
/// @param surface  What cutting has made of a mesh with `n_faces` faces.
/// @return         #faces: 1 for those.
[[nodiscard]] std::vector<std::uint8_t> which_are_of_unfinished_parts(const CutSurface& surface,
                                                                      std::size_t n_faces);

}  // namespace meshalyzer
