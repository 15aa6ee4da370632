#pragma once

#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/intersecting_pair.h"
#include "meshalyzer/spatial/pair_limits.h"
#include "meshalyzer/spatial/pair_listener.h"

#include <cstddef>
#include <vector>

namespace meshalyzer {

/// Finds all pairs of faces of one mesh that intersect ("Intersecting faces" in
/// doc/definitions.md), each with its kind.
///
/// Two faces intersect when their closed triangles share a point that is not on a vertex or edge
/// which both have by file id. The answer is exact for every pair; a face of zero area counts as
/// the segment or point it is.
///
/// @param tree  The tree over the faces of `cut`.
/// @return      The pairs, ascending by file face; the same for any number of threads.
/// @complexity  O(#F log #F + candidates), where a candidate is a pair of faces whose boxes meet.
[[nodiscard]] std::vector<IntersectingPair> find_self_intersections(const CutMesh& cut,
                                                                    const FaceTree& tree);

/// Finds those that a search within limits finds.
///
/// @param also  Receives them too, as they are found; may be null.
[[nodiscard]] FoundPairs find_self_intersections(const CutMesh& cut, const FaceTree& tree,
                                                 const PairLimits& limits,
                                                 PairListener* also = nullptr);

/// Passes the pairs that find_self_intersections() finds to a listener, and keeps none.
///
/// @param limits  Decides when the search ends early; nothing is listed here.
/// @return        True if the search was complete.
bool visit_self_intersections(const CutMesh& cut, const FaceTree& tree, const PairLimits& limits,
                              PairListener& listener);

}  // namespace meshalyzer
