#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <span>
#include <vector>

namespace meshalyzer {

// Private to part_contacts().

/// Returns the directions in which to try to move a vertex out of the way of others at its place,
/// the likeliest first; longest coordinate 1.
///
/// Behind all its faces, where the solid is, as far from all of them as can be; before all of them;
/// towards and away from the middle of its neighbours.
///
/// @param faces  Round it, the vertex first.
[[nodiscard]] std::vector<Vec3> parting_directions(std::span<const Corners> faces);

/// Returns all 26 along axes and diagonals: where nothing else has helped.
[[nodiscard]] const std::vector<Vec3>& grid_directions();

}  // namespace meshalyzer
