#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <vector>

namespace meshalyzer {

/// Finds the intersecting pairs that have at least one of the given faces, see
/// find_self_intersections_of(), in the way that takes less time for so many faces.
[[nodiscard]] std::vector<IntersectingPair> find_pairs_of(const PreparedMesh& mesh,
                                                          const std::vector<Index>& faces);

/// Joins the pairs of some faces and all others, in the order of find_self_intersections().
[[nodiscard]] std::vector<IntersectingPair> joined_pairs(
    std::vector<IntersectingPair> of_faces, const std::vector<IntersectingPair>& others);

}  // namespace meshalyzer
