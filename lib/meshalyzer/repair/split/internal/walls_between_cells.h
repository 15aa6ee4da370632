#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"

#include <vector>

namespace meshalyzer {

/// Finds walls that are stored once between two cells of one surface, as in the boundaries of
/// finite elements: faces with an enclosed cell on either side, and not the same one. The sides of
/// faces that follow each other round an edge belong to one cell, and a cell is enclosed if its
/// volume is positive, exactly.
///
/// Walls that meet at edges are returned together, and only if one of their edges has an odd number
/// of faces: else the surface is closed as it is, and they may be the sides of a cavity. A cavity
/// that has an edge in common with such walls cannot be told from a cell, because walls that are
/// stored once may point either way. Surfaces in which faces intersect or have no area have no
/// cells.
///
/// @return      The faces of each set of walls, ascending, in order of their lowest faces.
/// @complexity  O(#F) if an edge has an odd number of faces above two, else O(number of edges with
///              more than two); besides the search for intersecting pairs.
[[nodiscard]] std::vector<std::vector<Index>> find_walls_between_cells(const PreparedMesh& mesh);

}  // namespace meshalyzer
