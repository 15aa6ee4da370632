#pragma once

#include "meshalyzer/boolean/combine_solids.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

namespace meshalyzer {

/// The result of a boolean operation, and what was done to mend it.
struct MendedMesh {
  /// Tells whether anything was done.
  [[nodiscard]] bool is_mended() const {
    return is_parted || is_oriented || is_repaired || is_subtracted_again;
  }

  TrackedMesh mesh;
  /// Parts that touched along an edge or at a vertex were moved off each other.
  bool is_parted = false;
  /// Parts that rounding had turned inside out were oriented outwards; nothing was moved.
  bool is_oriented = false;
  /// All of it was repaired, as a solid.
  bool is_repaired = false;
  /// Other meshes were subtracted from it again.
  bool is_subtracted_again = false;
  /// An upper bound of how far all this has moved the surface.
  double largest_move = 0.0;
};

/// Makes the result of a boolean operation manifold, outward, and free of intersections: parts
/// surfaces that touch along an edge or at a vertex, orients outwards what this or rounding has
/// turned inside out, which are parts that are flat but for rounding, and repairs as a solid what
/// still intersects itself, or whose operation is CombineOutcome::Unfinished: a repair knows more
/// ways to cut what rounding makes intersect again and again.
///
/// @param combined  The result; a manifold and outward one is left unchanged.
/// @param outcome   How the operation has ended: Done or Unfinished.
/// @param is_moved  Tells whether vertices were moved off other meshes after the operation, so that
///                  faces may intersect although it is Done.
/// @param options   The options of the operation: the maximum distance between the surfaces before
///                  and after, and when to stop.
/// @throws InvalidArgument  if the maximum distance is no length: negative or not finite.
[[nodiscard]] MendedMesh mend_combined(TrackedMesh combined, CombineOutcome outcome, bool is_moved,
                                       const CombineOptions& options);

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
