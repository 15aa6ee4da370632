#pragma once

#include "meshalyzer/base/types.h"

#include <span>
#include <vector>

namespace meshalyzer {

// The filter in front of find_indistinguishable_vertices(), private to the geometry module.

/// Finds the points that may be at the same place as another one (Coincidence::Tolerant): all that
/// are, and few others where the points are spread out.
///
/// @param positions  Finite.
/// @return           Their indices, ascending.
/// @complexity       O(n) time, 4 bytes a point of temporary memory.
[[nodiscard]] std::vector<Index> find_crowded_points(std::span<const Vec3> positions);

}  // namespace meshalyzer
