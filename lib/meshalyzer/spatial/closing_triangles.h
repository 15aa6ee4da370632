#pragma once

#include "meshalyzer/base/corners.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// Returns triangles that close a surface: together with its own, every edge is run along equally
/// often in both directions, so that winding numbers are whole. Equal positions are one vertex, and
/// the surface may be of any kind: a soup, inconsistently oriented, not manifold.
///
/// The boundary, the edges that are run along oftener in one direction, falls into closed walks.
/// The closing triangles halve each walk again and again: most of them are small and lie at the
/// boundary. They are a means of computing, and no patch: they may intersect anything.
///
/// @return     Fewer triangles than the boundary has edges. If all triangles of the surface are
///             reversed by exchanging their last two corners, so are these.
/// @complexity O(n log n).
[[nodiscard]] std::vector<Corners> closing_triangles(std::span<const Corners> triangles);

}  // namespace meshalyzer
