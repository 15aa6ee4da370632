#pragma once

#include "meshalyzer/mesh/corners.h"
#include "meshalyzer/mesh/edge_pairs.h"

#include <vector>

namespace meshalyzer {

/// The fans of a cut complex: at each vertex, the corners joined round it through paired sides.
struct Fans {
  /// The lowest corner of each fan: first the fans that the file vertices keep, which have the
  /// vertex's lowest corner (kNoIndex where no face uses the vertex), then the further fans.
  std::vector<Index> first_corner;
  /// The file vertex of each further fan, ordered by vertex, then by the fan's lowest corner.
  std::vector<Index> copies;
  /// The corners of each further fan.
  CornerLists copied_corners;
  /// The vertices of SideTable::non_manifold_vertices.
  std::vector<Index> non_manifold_vertices;
};

/// Finds the fans round every vertex.
///
/// @complexity O(#V + #F) time when every vertex has one fan; a vertex of n corners with several
///             fans costs O(n log n).
[[nodiscard]] Fans find_fans(const Complex& complex, const EdgePairs& pairs);

}  // namespace meshalyzer
