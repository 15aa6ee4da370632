#pragma once

#include "meshalyzer/mesh/soup.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// The resolutions of the grids to which vertices are moved before another attempt to cut faces,
/// see grid_spacing(); the finest first.
inline constexpr std::array kGridsOfAttempts{40, 36, 32};

/// Returns the positions of the vertices of a soup, for another attempt to cut faces that could not
/// be cut to the end: the corners of these are at the nearest points of a grid, and with them all
/// vertices at the same positions. The others stay.
///
/// Faces that are meant to coincide, but are some roundings apart, cross each other again and again
/// in layers that doubles cannot resolve. On the grid, their corners mostly coincide, and where
/// they do not they are many roundings apart.
///
/// @param is_moved  #faces: non-zero for those whose corners are moved.
/// @param spacing   The spacing of the grid.
/// @return          #vertices.
[[nodiscard]] std::vector<Vec3> corners_on_grid(const Soup& soup,
                                                std::span<const std::uint8_t> is_moved,
                                                double spacing);

}  // namespace meshalyzer
