#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

#include <vector>

namespace meshalyzer {

/// Tells whether two faces have corners at the same positions, in any order.
[[nodiscard]] bool is_same_surface(const Corners& a, const Corners& b);

/// A face that differs between the two meshes, and a face of the other mesh that is likely to be
/// near, because one was made of the other (kNoIndex: there is none).
struct ChangedFace {
  Index face = 0;
  Index other = kNoIndex;
};

/// The faces that a repair has changed: those that do not occupy the same points of space before
/// and after. Faces that are in no complex are left out.
struct ChangedFaces {
  std::vector<ChangedFace> of_input;
  /// The changed faces after the repair, without the faces of hole patches.
  std::vector<ChangedFace> of_repaired;
};

/// Compares a tracked mesh with the input that it was made of.
///
/// @complexity O(#F).
[[nodiscard]] ChangedFaces find_changed_faces(const Soup& input, const TrackedMesh& tracked);

}  // namespace meshalyzer
