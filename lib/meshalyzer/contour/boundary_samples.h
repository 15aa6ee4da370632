#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/mesh/soup.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// Samples the parts of faces that bound the solid which their mesh represents: the winding number
/// of the mesh is near 0 on one side, and at least near 1 in magnitude on the other. Parts near
/// holes, where it is midway, are left out.
///
/// @param pieces  Faces of the mesh, or pieces of faces.
/// @param reach   The two sides of a piece are examined at this distance from it; positive.
/// @return        Points about 1/128 of the mesh's diagonal apart; at least one for each piece
///                whose centroid bounds the solid.
/// @complexity    O(log #F) for each point.
[[nodiscard]] std::vector<Vec3> sample_boundary(const Soup& mesh, std::span<const Corners> pieces,
                                                double reach);

}  // namespace meshalyzer
