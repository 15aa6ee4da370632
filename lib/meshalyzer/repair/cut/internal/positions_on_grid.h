#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/repair/cut/internal/cut_surface.h"

#include <vector>

namespace meshalyzer {

/// Returns corners_on_grid() for the faces of the unfinished parts of a mesh.
///
/// @param surface  What cutting has made of the mesh.
[[nodiscard]] std::vector<Vec3> positions_on_grid(const Soup& soup, const CutSurface& surface,
                                                  double spacing);

}  // namespace meshalyzer
