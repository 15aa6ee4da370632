#pragma once

#include "meshalyzer/arrangement/windings.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// The closed chains among the faces of components that are not closed as a whole: solids that a
/// sheet crosses. A closed chain crosses every edge equally often in both directions.
struct ClosedPart {
  /// #components: 1 for those that have closed chains and whose other pieces, the sheets, all lie
  /// within what these enclose, so that they separate no inside from no outside.
  std::vector<std::uint8_t> encloses_rest;
  /// #cells: how often the closed chains of its component go round each, exactly.
  std::vector<int> windings;
};

/// Finds the closed chains of components.
///
/// @param wanted  #components: non-zero for those that are asked for.
/// @complexity    O(#F log #F), and an exact ray for each component.
[[nodiscard]] ClosedPart find_closed_part(const ArrangedSoup& arranged,
                                          std::span<const std::uint8_t> wanted);

}  // namespace meshalyzer
