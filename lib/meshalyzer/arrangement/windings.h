#pragma once

#include "meshalyzer/arrangement/arranged_soup.h"
#include "meshalyzer/base/items_by_group.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace meshalyzer {

/// Winding numbers of cells, from that of one cell of each component.
class CellWindings {
 public:
  /// @param cells  Must outlive this.
  explicit CellWindings(const Cells& cells);

  /// Sets the winding number of a cell, and those of all cells of its component.
  ///
  /// @param step  Returns by how much the number is higher behind a piece than in front of it.
  void spread_from(Index cell, int winding, const std::function<int(Index piece)>& step);

  /// #cells: 0 where none was set.
  [[nodiscard]] const std::vector<int>& of_cell() const { return of_cell_; }

 private:
  void set(Index cell, int winding);

  const Cells& cells_;
  ItemsByGroup pieces_;
  std::vector<int> of_cell_;
  std::vector<std::uint8_t> is_known_;
  /// The cells from which the numbers are still to spread.
  std::vector<Index> pending_;
};

/// The exact winding numbers of closed components with respect to cells.
struct Windings {
  /// #cells: the winding number of its own component round each cell; 0 in components that are not
  /// closed or not wanted.
  std::vector<int> own;
  /// #components: the winding number of the other closed components round each wanted one.
  std::vector<int> others;
};

/// Finds the winding numbers of cells with one exact ray for each component, and propagates them
/// across the pieces.
///
/// @param wanted  #components: non-zero for the wanted ones.
[[nodiscard]] Windings find_windings(const ArrangedSoup& arranged,
                                     std::span<const std::uint8_t> wanted);

}  // namespace meshalyzer
