#pragma once

#include "meshalyzer/geometry/curvature.h"
#include "meshalyzer/geometry/face_shape.h"

#include <array>
#include <vector>

namespace meshalyzer {

// Private to the geometry module.

/// The share of a face's area that each of its corners has. The sum is 1, but 3 for
/// VertexArea::OneRing.
using CornerShares = std::array<double, 3>;

/// Divides the area of all faces among their corners.
///
/// @return     #mesh faces: the shares, zero for a face without area.
/// @complexity O(#F).
[[nodiscard]] std::vector<CornerShares> corner_shares(const TriMesh& mesh,
                                                      const std::vector<FaceShape>& shapes,
                                                      VertexArea area);

}  // namespace meshalyzer
