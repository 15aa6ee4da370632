#pragma once

#include "meshalyzer/arrangement/triangulation.h"

namespace meshalyzer {

/// Triangulates the convex hull of points by a sweep: each point is joined to all edges of the hull
/// of those before it that it sees.
///
/// @param points  In lexicographic order, all different, not all in one line.
/// @complexity    O(n), counted in exact decisions.
[[nodiscard]] Triangulation triangulate_hull(Axis dropped, std::vector<const ExactPoint*> points);

}  // namespace meshalyzer
