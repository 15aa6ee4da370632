#pragma once

#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/intersecting_pair.h"
#include "meshalyzer/spatial/pair_limits.h"

#include <vector>

namespace meshalyzer {

/// Finds all pairs of faces, one of each of two meshes, that intersect ("Intersecting faces" in
/// doc/definitions.md), each with its kind.
///
/// Faces of different meshes intersect when their closed triangles share any point. Exact for every
/// pair; a face of zero area takes part as the segment or point it is. Ids mean nothing across
/// meshes: a pair is a duplicate when the corners of both are at the same three places, and
/// Unwelded and FoldOver do not occur.
///
/// @param tree_a  Over the faces of `a`; tree_b likewise.
/// @return        face_a is a file face of `a`, face_b one of `b`; ascending by (face_a, face_b).
/// The same for any number of threads, and mirrored when a and b change places.
/// @complexity    O(n log #F + candidates) for the n faces that one mesh has in the box of the
/// other, of which the lesser number counts; a candidate is a pair of faces whose boxes meet.
[[nodiscard]] std::vector<IntersectingPair> find_intersections(const CutMesh& a,
                                                               const FaceTree& tree_a,
                                                               const CutMesh& b,
                                                               const FaceTree& tree_b);

/// Counts the pairs that find_intersections() finds, and lists the first of them.
///
/// @param limits  max_found is not asked.
/// @return        The same for any number of threads, where the search goes to its end.
[[nodiscard]] FoundPairs count_intersections(const CutMesh& a, const FaceTree& tree_a,
                                             const CutMesh& b, const FaceTree& tree_b,
                                             const PairLimits& limits);

/// Tells whether any two faces, one of each mesh, share a point. Surfaces alone count: a mesh
/// wholly inside another does not meet it.
///
/// @complexity  That of find_intersections() at most, but stops at the first pair found.
[[nodiscard]] bool do_intersect(const FaceTree& a, const FaceTree& b);

}  // namespace meshalyzer
