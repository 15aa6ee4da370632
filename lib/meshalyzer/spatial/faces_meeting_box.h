#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/spatial/face_tree.h"

#include <vector>

namespace meshalyzer {

/// Returns the mesh faces of a tree whose boxes share a point with a box. The tree rounds boxes
/// outwards, so a few more may be among them.
///
/// @param box   Not empty.
/// @complexity  O(log #F + found) for boxes that are spread out.
[[nodiscard]] std::vector<Index> find_faces_meeting(const FaceTree& tree, const Box3& box);

}  // namespace meshalyzer
