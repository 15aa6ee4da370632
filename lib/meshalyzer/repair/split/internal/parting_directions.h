#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <span>
#include <vector>

namespace meshalyzer {

// Private to part_contacts().

/// Returns the directions in which to try to move a vertex away from others at its position, the
/// most promising first; their longest coordinate is 1.
///
/// They are: behind all its faces, where the solid is, as far from all of them as possible; in
/// front of all of them; towards and away from the middle of its neighbours.
///
/// @param faces  The faces round it, each with the vertex first.
[[nodiscard]] std::vector<Vec3> parting_directions(std::span<const Corners> faces);

/// Returns all 26 directions along axes and diagonals, to be tried if nothing else has helped.
[[nodiscard]] const std::vector<Vec3>& grid_directions();

}  // namespace meshalyzer
