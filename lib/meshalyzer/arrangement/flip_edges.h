#pragma once

#include "meshalyzer/arrangement/triangulation.h"

namespace meshalyzer {

/// Flips unconstrained edges until the triangulation is Delaunay in the projection, as far as
/// rounded coordinates can decide.
///
/// The choice of flips depends on rounded shapes; whether a flip is valid is decided exactly.
///
/// @complexity  O(n) flips for points in general position; at most a fixed number per triangle.
void flip_edges(Triangulation& triangulation);

}  // namespace meshalyzer
