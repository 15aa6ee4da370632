#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <vector>

namespace meshalyzer {

/// Returns those of the intersecting pairs of a surface that are to be cut.
///
/// Faces that meet only at copies of vertices are left alone, as those of solids that touch, or of
/// a surface that is not welded. There are two exceptions: they are connected, by pairs, with faces
/// that intersect otherwise; or closed parts overlap there, of which some walls lie inside.
///
/// @param pairs  All of them, as find_self_intersections() returns them.
[[nodiscard]] std::vector<IntersectingPair> pairs_to_cut(const Soup& soup, const CutMesh& cut,
                                                         const FaceTree& tree,
                                                         std::vector<IntersectingPair> pairs);

}  // namespace meshalyzer
