#pragma once

#include "meshalyzer/geometry/curvature.h"
#include "meshalyzer/geometry/face_shape.h"

#include <array>
#include <vector>

namespace meshalyzer {

// Private to the geometry module.

/// Tells how much of a face's area each of its corners has; 1 in all, but 3 for
/// VertexArea::OneRing.
using CornerShares = std::array<double, 3>;

/// Divides all faces among their corners.
///
/// @return     #mesh faces; of a face without area no corner has any.
/// @complexity O(#F).
[[nodiscard]] std::vector<CornerShares> corner_shares(const TriMesh& mesh,
                                                      const std::vector<FaceShape>& shapes,
                                                      VertexArea area);

}  // namespace meshalyzer
