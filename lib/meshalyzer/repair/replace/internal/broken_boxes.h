#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"

#include <vector>

namespace meshalyzer {

/// Returns disjoint boxes that hold the broken faces of a mesh, see find_broken_faces().
///
/// @param margin  The least distance between a broken face and the sides of its box.
/// @return        The boxes, in an order that depends on the faces alone; none if there are so many
///                places that the mesh is broken as a whole.
/// @complexity    That of find_broken_faces(), and O(#broken faces #boxes).
[[nodiscard]] std::vector<Box3> boxes_round_broken_faces(const PreparedMesh& mesh, double margin);

}  // namespace meshalyzer
