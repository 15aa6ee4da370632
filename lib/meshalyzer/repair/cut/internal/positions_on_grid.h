#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/repair/cut/internal/cut_surface.h"

#include <vector>

namespace meshalyzer {

/// Returns the positions of the vertices of a mesh, for another attempt to cut what could not be
/// cut to the end: the vertices of the unfinished parts are at the nearest points of a grid, and
/// with them all vertices at the same positions. The others stay.
///
/// Faces that are meant to coincide, but are some roundings apart, cross each other again and again
/// in layers that doubles cannot resolve. On the grid, their corners mostly coincide, and where
/// they do not they are many roundings apart.
///
/// @param surface  What cutting has made of the mesh.
/// @param spacing  The spacing of the grid.
/// @return         #vertices.
[[nodiscard]] std::vector<Vec3> positions_on_grid(const Soup& soup, const CutSurface& surface,
                                                  double spacing);

}  // namespace meshalyzer
