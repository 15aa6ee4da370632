#pragma once

#include "meshalyzer/boolean/combine_solids.h"
#include "meshalyzer/repair/driver/options.h"
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

/// The result of a boolean operation, repaired.
struct MendedMesh {
  TrackedMesh mesh;
  /// Tells whether there was something to repair, and how far that has moved the surface.
  bool is_mended = false;
  double largest_move = 0.0;
};

/// Parts surfaces that touch along an edge or at a vertex, as a repair of `non-manifold` does, and
/// orients outwards what this or rounding has turned inside out: parts that are flat but for
/// rounding. A mesh that is manifold and outward is left unchanged.
///
/// @param max_deviation  The maximum distance by which a vertex may move.
/// @throws InvalidArgument  if that is no length: negative or not finite.
[[nodiscard]] MendedMesh part_combined(TrackedMesh combined, double max_deviation);

/// Tells whether a mesh is manifold, and no faces of it intersect.
[[nodiscard]] bool is_embedded(const Soup& soup);

/// Repairs the result of an operation that is CombineOutcome::Unfinished, as a solid: a repair
/// knows more ways to cut what rounding makes intersect again and again.
///
/// @param options  The options of the operation: the maximum distance between the surfaces before
/// and after, and when to stop.
/// @throws InvalidArgument  as fix_defects().
[[nodiscard]] MendedMesh mend_combined(const TrackedMesh& combined, const CombineOptions& options);

/// Subtracts others again, as subtract_and_part() does, from a difference that still meets them or
/// intersects itself: because it could not be moved off them, or because a repair has moved it
/// back. This is repeated for some rounds, as long as fewer pairs of faces are left.
///
/// @param others   What the difference is to have no point in common with.
/// @param options  As of mend_combined(); the distance is the one that this may add.
/// @throws InvalidArgument  as combine_solids().
[[nodiscard]] MendedMesh keep_off(MendedMesh mended, const Soup& others,
                                  const CombineOptions& options);

}  // namespace meshalyzer
