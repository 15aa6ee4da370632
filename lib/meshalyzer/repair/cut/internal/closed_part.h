#pragma once

#include "meshalyzer/arrangement/windings.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// The closed chains among the faces of components that are not closed as a whole: solids that a
/// sheet crosses. A closed chain crosses every edge equally often in both directions.
struct ClosedPart {
  /// #components: 1 for those that have closed chains and whose other pieces all lie within what
  /// these enclose, so that they separate no inside from no outside.
  std::vector<std::uint8_t> encloses_rest;
  /// #components: 1 for these and for those that have closed chains and a border, so that the other
  /// faces are sheets.
  std::vector<std::uint8_t> tells_inside;
  /// #components: 1 for those most of whose edges have one face only.
  std::vector<std::uint8_t> is_loose;
  /// #cells: how often the closed chains of its component go round each, exactly, and once more if
  /// the component lies inside others, where it can only be a cavity; 0 if there are no chains.
  std::vector<int> windings;
  /// #pieces: 1 for those that a face of a closed chain covers.
  std::vector<std::uint8_t> is_of_chain;
};

/// Finds the closed chains of components.
///
/// @param wanted  #components: non-zero for those that are asked for.
/// @complexity    O(#F log #F), and an exact ray for each component.
[[nodiscard]] ClosedPart find_closed_part(const ArrangedSoup& arranged,
                                          std::span<const std::uint8_t> wanted);

}  // namespace meshalyzer
