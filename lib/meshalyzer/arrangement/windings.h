#pragma once

#include "meshalyzer/arrangement/arranged_soup.h"

namespace meshalyzer {

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
