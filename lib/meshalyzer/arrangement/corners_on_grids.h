#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// Returns the positions of the vertices of a soup for further attempts to cut faces that could not
/// be cut to the end: the corners of these are at the nearest points of a grid, and with them all
/// vertices at the same positions. The others stay.
///
/// Faces that are meant to coincide, but are some roundings apart, cross each other again and again
/// in layers that doubles cannot resolve. On the grid, their corners mostly coincide, and where
/// they do not they are many roundings apart.
///
/// @param is_moved       #faces: non-zero for those whose corners are moved.
/// @param max_deviation  Vertices move by at most a share of it.
/// @return  #attempts x #vertices, that of the finest grid first. Grids on which all vertices are
///          where they were in the attempt before are left out.
[[nodiscard]] std::vector<std::vector<Vec3>> corners_on_grids(
    const Soup& soup, std::span<const std::uint8_t> is_moved, double max_deviation);

}  // namespace meshalyzer
