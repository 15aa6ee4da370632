#pragma once

#include "meshalyzer/arrangement/windings.h"
#include "meshalyzer/base/stop_query.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// Winding numbers of the cells of components that are not closed, estimated at some points beside
/// their pieces.
struct EstimatedWindings {
  /// #cells: the mean, weighted by area; 0 where no piece was sampled.
  std::vector<double> of_cell;
  /// #components: 1 for those of which at least half of the area separates whole winding numbers;
  /// the others are sheets.
  std::vector<std::uint8_t> bounds_solid;
};

/// @param wanted         #components: non-zero for those that are to be estimated.
/// @param wants_to_stop  Called now and then, from any thread; once it returns true, the numbers
/// mean nothing. May be empty.
/// @complexity           O(#F log #F) for the first piece, O(log #F) for each other.
[[nodiscard]] EstimatedWindings estimate_windings(const ArrangedSoup& arranged,
                                                  std::span<const std::uint8_t> wanted,
                                                  const StopQuery& wants_to_stop);

}  // namespace meshalyzer
