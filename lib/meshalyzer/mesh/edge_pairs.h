#pragma once

#include "meshalyzer/mesh/corners.h"

#include <vector>

namespace meshalyzer {

/// Tells which sides of the faces of a complex are joined, and which edges are cut.
struct EdgePairs {
  /// #corners: the side that crosses the same edge in the other direction, where the edge has
  /// exactly these two; kNoIndex where it is a border or cut.
  std::vector<Index> opposite;
  std::size_t n_pairs = 0;
  /// The sides at each edge with more than two faces. Edges in order of their two vertices, sides
  /// ascending.
  CornerLists non_manifold;
  /// The two sides at each edge that has just two, both in the same direction; same order.
  CornerLists flipped;
};

/// Pairs the sides of all faces: an edge with two faces that cross it in opposite directions joins
/// them.
///
/// @param complex  At most 2^31 vertices and 2^30 faces.
/// @complexity O(#V + #F) but for sorting the sides within the bucket of each vertex; 26 bytes a
/// face beside the
///             result.
[[nodiscard]] EdgePairs pair_edges(const Complex& complex);

}  // namespace meshalyzer
