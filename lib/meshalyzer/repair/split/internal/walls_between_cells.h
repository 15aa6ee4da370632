#pragma once

#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/prepared/prepared_mesh.h"

#include <vector>

namespace meshalyzer {

/// The walls between cells, and how the surfaces with such walls are oriented.
struct WallsBetweenCells {
  /// The faces of each set of walls that meet at edges, ascending, in order of their lowest faces.
  std::vector<std::vector<Index>> sets;
  /// The faces that point into the only enclosed cell beside them, ascending.
  std::vector<Index> inward;
};

/// Finds walls that are stored once between two cells of one surface, as in the boundaries of
/// finite elements: faces with an enclosed cell on either side, and not the same one. The sides of
/// faces that follow each other round an edge belong to one cell, and a cell is enclosed if its
/// volume is positive, exactly, and none of its faces ends at a border.
///
/// Walls that meet at edges are returned together, and only if an odd number of faces between
/// different cells meets at one of these edges: else the surface is closed as it is, and they may
/// be the sides of a cavity. A cavity that has an edge in common with walls cannot be told from a
/// cell, because walls that are stored once may point either way. Nothing is found in a component
/// in which faces intersect, are stored twice, or have no area.
///
/// @param wants_to_stop  See PassInput; once it returns true, the result is empty.
/// @complexity  O(number of edges with more than two faces) if none of them has an odd number;
///              else O(#F log #F), besides the search for intersecting pairs.
[[nodiscard]] WallsBetweenCells find_walls_between_cells(const PreparedMesh& mesh,
                                                         const StopQuery& wants_to_stop);

}  // namespace meshalyzer
