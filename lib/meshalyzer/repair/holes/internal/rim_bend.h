#pragma once

#include "meshalyzer/repair/holes/internal/hole_loop.h"
#include "meshalyzer/repair/holes/internal/patch_check.h"

namespace meshalyzer {

/// Measures how sharply a patch bends from the surface round its hole: the mean angle, in radians,
/// between the faces on both sides of the hole's edges, weighted by their lengths.
[[nodiscard]] double mean_rim_bend(const PreparedMesh& mesh, const HoleLoop& loop,
                                   const Patch& patch);

/// Returns the sum over the edges of a hole of the angle between the faces on both sides times the
/// edge's length, in radians times the mesh's unit.
[[nodiscard]] double total_rim_bend(const PreparedMesh& mesh, const HoleLoop& loop,
                                    const Patch& patch);

/// Tells whether the surface round a hole bends as if it continued across the hole, so that a
/// smooth patch is a better guess than the given one, which is without new vertices.
///
/// The curvature across each edge of the hole, taken from the faces beyond, predicts how far the
/// surface would turn on its way to the middle of the hole. If this makes up less than a third of
/// the bend at the edge of the patch, the edge is a crease, such as the rim of a tube or a corner
/// of a box. If there is about no bend, the hole is flat.
///
/// @complexity  O(#edges of the loop x valence).
[[nodiscard]] bool bends_into_hole(const PreparedMesh& mesh, const HoleLoop& loop,
                                   const Patch& patch);

}  // namespace meshalyzer
