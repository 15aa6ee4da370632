#pragma once

#include "meshalyzer/repair/holes/internal/loop_polygon.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace meshalyzer {

class TriangulationMemory;

/// Loops of up to this number of edges are left to triangulate_loop().
inline constexpr std::size_t kSmallLoop = 192;

/// Triangulates a loop of any size: cuts ears off it, those with the shortest chord first, until
/// triangulate_loop() can do the rest; with LoopWeight::Flat until three corners are left.
///
/// Ears are cut in the loop's projection along the axis that shows it best, exactly: if that is a
/// simple polygon, no two triangles overlap in it. If it is none, the remaining ears are cut in
/// order once no proper ear is left. A slot round a body is no simple polygon from any side: ears
/// are also cut in the projections that show the faces beyond them best, and of both triangulations
/// the one that bends less from these faces is taken. With LoopWeight::Flat the faces beyond do not
/// count.
///
/// @param memory  If it is given, what triangulate_loop() has done before is recalled.
/// @return        The triangles as triangulate_loop() returns them.
/// @complexity    O(n log n) for loops whose corners are about evenly spread.
[[nodiscard]] std::optional<std::vector<Triangle>> triangulate_large_loop(
    const LoopPolygon& polygon, const LoopRules& rules, TriangulationMemory* memory = nullptr);

}  // namespace meshalyzer
