#pragma once

#include "meshalyzer/arrangement/rounded_faces.h"

namespace meshalyzer {

/// Tells whether new faces are thinner than a width, as remove_slivers() takes it.
///
/// @complexity  O(#faces).
[[nodiscard]] bool has_slivers(const RoundedFaces& faces, double width);

/// Removes those new faces that are thinner than a width. Rounding turns their planes in any
/// direction, so that they would intersect others again and again. A short edge is collapsed to its
/// vertex of lower number; where an altitude is low, the longest edge is moved through the opposite
/// corner, in all faces that have this edge. Each step moves the surface by less than the width,
/// and several may follow each other. No new face without area is left; no other face is lost.
///
/// The work is bounded by the number of thin faces, so that some may be left where many have an
/// edge in common.
///
/// @param width  Edges and altitudes below this are short.
/// @complexity   O(#faces), and O(#positions + n) more for n thin faces.
void remove_slivers(RoundedFaces& faces, double width);

}  // namespace meshalyzer
