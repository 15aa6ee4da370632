#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/intersecting_pair.h"
#include "meshalyzer/spatial/pair_limits.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// Finds the pairs of find_self_intersections() that have at least one of the given faces.
///
/// @param tree   The tree over the faces of `cut`.
/// @param faces  File faces, ascending, each once; faces outside the complex meet nothing.
/// @return       The pairs, ascending by file face, each once; the same for any number of threads.
/// @complexity   O(#F + n log #F + candidates) for n faces.
[[nodiscard]] std::vector<IntersectingPair> find_self_intersections_of(
    const CutMesh& cut, const FaceTree& tree, std::span<const Index> faces);

/// Finds those that a search within limits finds.
[[nodiscard]] FoundPairs find_self_intersections_of(const CutMesh& cut, const FaceTree& tree,
                                                    std::span<const Index> faces,
                                                    const PairLimits& limits);

/// Does the same without a tree over all faces, in a part of the time if the given faces are few.
///
/// @param soup        The mesh that `cut` was built from.
/// @complexity        O(#F log n + candidates) for n faces.
[[nodiscard]] FoundPairs find_self_intersections_of(const CutMesh& cut, const Soup& soup,
                                                    std::span<const Index> faces,
                                                    const PairLimits& limits = {});

/// Tells whether a tree over all faces is worth the time that it takes to make it.
[[nodiscard]] bool is_worth_a_tree(std::size_t n_given_faces, std::size_t n_faces);

}  // namespace meshalyzer
