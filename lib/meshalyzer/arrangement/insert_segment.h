#pragma once

#include "meshalyzer/arrangement/triangulation.h"

namespace meshalyzer {

/// Makes edges of the segment between two vertices, and marks them as constrained.
///
/// Vertices on it split it. It must not cross a constrained edge except in a vertex. The triangles
/// that it crosses are replaced by others, found by cutting ears off the polygons on both sides.
///
/// @return      The vertices on the segment, from one end to the other, including both.
/// @complexity  O(k log k) for k triangles crossed, plus the degrees of the vertices on it.
std::vector<Index> insert_segment(Triangulation& triangulation, Index from, Index to);

}  // namespace meshalyzer
