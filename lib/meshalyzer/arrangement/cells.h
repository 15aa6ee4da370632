#pragma once

#include "meshalyzer/arrangement/arrangement.h"
#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// The cells into which the pieces of an arrangement divide space.
///
/// Cells are determined by the space between consecutive pieces round an edge. So each
/// edge-connected component of pieces has cells of its own: if one component lies inside another,
/// its outer cell is a part of one of the other's. An edge with only one piece joins no cells, so
/// that a surface with small holes still has an inside.
struct Cells {
  std::size_t count = 0;
  /// 2 #pieces: the cell in front of each piece, where its normal points, and the one behind it.
  std::vector<Index> of_side;

  std::size_t n_components = 0;
  /// #pieces: the component of each.
  std::vector<Index> component_of;
  /// #components: 1 if each edge is crossed equally often in both directions, counting each piece
  /// as often as faces cover it.
  std::vector<std::uint8_t> is_closed;

  [[nodiscard]] Index front(std::size_t piece) const { return of_side[2 * piece]; }
  [[nodiscard]] Index behind(std::size_t piece) const { return of_side[2 * piece + 1]; }
};

/// Returns the pieces that bound each cell, ascending; a piece with the cell on both sides occurs
/// twice.
///
/// @complexity O(#pieces).
[[nodiscard]] ItemsByGroup pieces_by_cell(const Cells& cells);

/// Finds the cells of an arrangement, exactly. No piece may have zero area.
///
/// @param soup  The soup that was cut.
/// @complexity  O(#pieces), and O(n log n) for n pieces round one edge.
[[nodiscard]] Cells find_cells(const Soup& soup, const Arrangement& arrangement);

}  // namespace meshalyzer
