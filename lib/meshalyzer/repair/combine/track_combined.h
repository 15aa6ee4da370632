#pragma once

#include "meshalyzer/boolean/combine_solids.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

namespace meshalyzer {

/// Tracks the result of a boolean operation as a changed mesh, so that ids, groups and normals are
/// carried as a repair carries them. Faces that were turned over have their normals turned too.
/// Vertices that were moved by part_from() are at their positions in the result; those that no face
/// uses are dropped, and the records are numbered 1, 2, ..., n.
///
/// @param source  The soup of all operands, or of the first alone: then faces of the others count
/// as patches of holes.
[[nodiscard]] TrackedMesh track_combined(const Soup& source, const CombinedSolid& solid);

/// Tells whether a boolean operation has left a mesh unchanged, with all of its faces and no
/// others.
///
/// @param source  The soup as track_combined() takes it.
[[nodiscard]] bool is_unchanged(const Soup& source, const CombinedSolid& solid);

}  // namespace meshalyzer
