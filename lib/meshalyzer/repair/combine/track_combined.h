#pragma once

#include "meshalyzer/boolean/combine_solids.h"
#include "meshalyzer/repair/driver/options.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

namespace meshalyzer {

/// Makes the mesh that a boolean operation has made a change of a mesh, so that ids, groups and
/// normals are carried as a repair carries them. Faces that were turned over have their normals
/// turned too. Vertices that were moved by part_from() are where the result has them; those that no
/// face uses go, and the records are numbered 1, 2, ..., n.
///
/// @param source  The soup of all operands, or of the first alone: then what comes of the others
///                counts as patches of holes.
[[nodiscard]] TrackedMesh track_combined(const Soup& source, const CombinedSolid& solid);

/// Tells whether a boolean operation has left a mesh as it was: all of its faces, and no others.
///
/// @param source  As track_combined() takes it.
[[nodiscard]] bool is_unchanged(const Soup& source, const CombinedSolid& solid);

/// What a boolean operation has made, parted where it touches itself.
struct PartedMesh {
  TrackedMesh mesh;
  /// Tells whether anything was done, and how far vertices have moved at most.
  bool is_parted = false;
  double largest_move = 0.0;
};

/// Parts what touches along an edge or at a vertex, as a repair of `non-manifold` does; a mesh that
/// is manifold stays.
///
/// @param max_deviation  No vertex moves farther. A length.
[[nodiscard]] PartedMesh part_combined(TrackedMesh combined, double max_deviation);

}  // namespace meshalyzer
