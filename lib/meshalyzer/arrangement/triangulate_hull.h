#pragma once

#include "meshalyzer/arrangement/triangulation.h"

namespace meshalyzer {

/// Triangulates the convex hull of points by a sweep: each point is joined to all edges that it
/// sees of the hull of the points before it.
///
/// @param points  The points in lexicographic order, all different, not all collinear.
/// @complexity    O(n) exact decisions.
[[nodiscard]] Triangulation triangulate_hull(Axis dropped, std::vector<const ExactPoint*> points);

}  // namespace meshalyzer
