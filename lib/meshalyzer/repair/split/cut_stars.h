#pragma once

#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/split/vertex_stars.h"
#include "meshalyzer/topology/disjoint_sets.h"

#include <span>

namespace meshalyzer {

/// Gives each fan beyond the first of each star a copy of the vertex.
///
/// @param fans      By place in all stars: as find_fans_of_star().
/// @param together  Sets of stars that are to be one operation; those that change the same face
///                  join.
/// @return          One operation for each set that has something to cut, in order of their lowest
///                  vertices.
[[nodiscard]] Edits cut_stars(const Soup& soup, const VertexStars& stars,
                              std::span<const Index> fans, DisjointSets together);

}  // namespace meshalyzer
