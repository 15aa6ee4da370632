#pragma once

#include "meshalyzer/repair/holes/internal/loop_polygon.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace meshalyzer {

/// Loops of up to so many edges are for triangulate_loop() alone.
inline constexpr std::size_t kSmallLoop = 192;

/// Triangulates a loop of any size: cuts ears off it, those with the shortest chord first, until
/// triangulate_loop() can do the rest; with LoopWeight::Flat until three corners are left.
///
/// Ears are cut as from the loop's projection along the axis that shows it best, exactly: where
/// that is a simple polygon, no two triangles overlap in it. Where it is none, the ears that are
/// left when no other is are taken as they come.
///
/// @return      As triangulate_loop().
/// @complexity  O(n log n) for loops whose corners are about evenly spread.
[[nodiscard]] std::optional<std::vector<Triangle>> triangulate_large_loop(
    const LoopPolygon& polygon, const LoopRules& rules);

}  // namespace meshalyzer
