#pragma once

#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/intersecting_pair.h"
#include "meshalyzer/spatial/pair_limits.h"

#include <vector>

namespace meshalyzer {

/// Finds all pairs of faces, one of each of two meshes, that intersect ("Intersecting faces" in
/// doc/definitions.md), each with its kind.
///
/// Faces of different meshes intersect when their closed triangles share any point. The answer is
/// exact for every pair; a face of zero area counts as the segment or point it is. Ids have no
/// meaning across meshes: a pair is a duplicate when the corners of both are at the same three
/// places, and Unwelded and FoldOver do not occur.
///
/// @param tree_a  The tree over the faces of `a`; tree_b likewise.
/// @return        The pairs, ascending by (face_a, face_b); face_a is a file face of `a`, face_b
///                one of `b`. They are the same for any number of threads, and mirrored when a and
///                b are exchanged.
/// @complexity    O(n log #F + candidates), where n is the number of faces that one mesh has in the
///                box of the other, the smaller of the two, and a candidate is a pair of faces
///                whose boxes meet.
[[nodiscard]] std::vector<IntersectingPair> find_intersections(const CutMesh& a,
                                                               const FaceTree& tree_a,
                                                               const CutMesh& b,
                                                               const FaceTree& tree_b);

/// Counts the pairs that find_intersections() finds, and lists the first of them.
///
/// @param limits  The limits of the list and of the time; max_found is ignored.
/// @return        The result, which is the same for any number of threads if the search is
///                complete.
[[nodiscard]] FoundPairs count_intersections(const CutMesh& a, const FaceTree& tree_a,
                                             const CutMesh& b, const FaceTree& tree_b,
                                             const PairLimits& limits);

/// Tells whether any two faces, one of each mesh, share a point. Only surfaces count: a mesh wholly
/// inside another does not intersect it.
///
/// @complexity  At most that of find_intersections(); the search stops at the first pair.
[[nodiscard]] bool do_intersect(const FaceTree& a, const FaceTree& b);

}  // namespace meshalyzer
