#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/pass.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// Returns the positions at which faces of a closed mesh touch at copies of vertices; none if
/// anything else is wrong with the mesh.
///
/// @param mesh  Prepared from tracked.soup.
[[nodiscard]] std::vector<Vec3> contact_points(const TrackedMesh& tracked,
                                               const PreparedMesh& mesh);

/// Unites a mesh whose faces do not intersect with small solids round some of its points. Where
/// many parts touch at a vertex, such a solid takes the place of the vertex, so that the parts meet
/// it along curves of their own.
///
/// @param points  The points; the result is empty if there are none.
[[nodiscard]] PassResult join_at_points(const PassInput& input, std::span<const Vec3> points);

}  // namespace meshalyzer
