#pragma once

#include "meshalyzer/repair/holes/internal/loop_polygon.h"

#include <optional>
#include <vector>

namespace meshalyzer {

/// Triangulates a loop without new vertices, as well as any triangulation can (Barequet and Sharir
/// 1995, "Filling gaps in the boundary of a polyhedron"; weights as Liepa 2003, "Filling holes in
/// meshes"): with the fewest collinear triangles, then the fewest thin ones, then the least weight
/// by the rules.
///
/// In a plane, a triangulation without overlap has the least bend as well as the least area.
///
/// @return      Triangles of the polygon's file vertices, which run along its edges forwards;
/// nothing if the rules permit no triangulation.
/// @complexity  O(n^3) time and O(n^2) memory.
[[nodiscard]] std::optional<std::vector<Triangle>> triangulate_loop(const LoopPolygon& polygon,
                                                                    const LoopRules& rules);

}  // namespace meshalyzer
