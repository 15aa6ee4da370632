#pragma once

#include "meshalyzer/repair/edits/tracked_mesh.h"

#include <vector>

namespace meshalyzer {

/// Splits a mesh into its components (faces joined through vertices), the largest first, by faces,
/// then by lowest face. Elements keep their order, groups and normals, and their ids where the
/// format names them; a cavity stays a mesh of its own.
///
/// A face that is in no complex goes with the first of its vertices that belongs to a component; a
/// vertex of faces that go to several meshes is in each of them. What belongs to no component stays
/// with the first mesh: other faces, vertices that no face uses, normals that no corner uses. A
/// mesh of one component or none comes back as it is; groups that a part has no face of are not
/// listed there.
///
/// @return           At least one.
/// @complexity       O(#V + #F log #F), and O(elements added by repairs) for each part that has
/// any.
[[nodiscard]] std::vector<TrackedMesh> separate(const TrackedMesh& tracked);

}  // namespace meshalyzer
