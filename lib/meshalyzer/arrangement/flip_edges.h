#pragma once

#include "meshalyzer/arrangement/triangulation.h"

namespace meshalyzer {

/// Flips edges that are not constrained where that makes triangles rounder, until the triangulation
/// is Delaunay in the projection as far as rounded coordinates tell.
///
/// What is flipped is a matter of shape and rounds; that it may be flipped is exact.
///
/// @complexity  O(n) flips for points in general position; never more than a fixed number a
/// triangle.
void flip_edges(Triangulation& triangulation);

}  // namespace meshalyzer
