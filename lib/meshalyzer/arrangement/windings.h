#pragma once

#include "meshalyzer/arrangement/arranged_soup.h"

namespace meshalyzer {

/// Tells how often closed components go round cells: exact winding numbers.
struct Windings {
  /// #cells: how often its own component goes round each cell; 0 in components that are not closed
  /// or were not asked for.
  std::vector<int> own;
  /// #components: how often the other closed components go round each one that was asked for.
  std::vector<int> others;
};

/// Finds the winding numbers of cells: one exact ray for each component, and from there across the
/// pieces.
///
/// @param wanted  #components: non-zero for those that are asked for.
[[nodiscard]] Windings find_windings(const ArrangedSoup& arranged,
                                     std::span<const std::uint8_t> wanted);

}  // namespace meshalyzer
