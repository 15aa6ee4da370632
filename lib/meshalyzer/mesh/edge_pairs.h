#pragma once

#include "meshalyzer/mesh/corners.h"

#include <vector>

namespace meshalyzer {

/// The sides of the faces of a complex that are joined, and the edges that are cut.
struct EdgePairs {
  /// #corners: the side that crosses the same edge in the other direction, if the edge has exactly
  /// these two; kNoIndex if the edge is a border or cut.
  std::vector<Index> opposite;
  /// The sides at each edge with more than two faces, ascending; the edges in order of their two
  /// vertices.
  CornerLists non_manifold;
  /// The two sides at each edge that has exactly two, both in the same direction, in the same
  /// order.
  CornerLists flipped;
};

/// Pairs the sides of all faces: an edge with two faces that cross it in opposite directions joins
/// them.
///
/// @param complex  At most 2^31 vertices and 2^30 faces.
/// @complexity O(#V + #F), apart from sorting the sides within the bucket of each vertex; in
///             parallel; 12 bytes per face of temporary memory.
[[nodiscard]] EdgePairs pair_edges(const Complex& complex);

}  // namespace meshalyzer
