#pragma once

#include "meshalyzer/arrangement/windings.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// The treatment of pockets, regions that faces surround in the wrong direction, as where a surface
/// has been pushed through itself.
enum class Pockets : std::uint8_t {
  Dropped,
  Kept,
  /// Pockets are dropped, and do not count as lost: they bound no part of the solid.
  Forgotten,
};

/// The decision on a piece of an arrangement.
enum class PieceFate : std::uint8_t {
  /// The piece stays as it is.
  Kept,
  /// The piece stays, turned over.
  Turned,
  /// The piece is dropped, because both of its sides are inside the solid.
  Interior,
  /// The piece is dropped, because its faces cancel each other out.
  Cancelled,
  /// The piece is dropped, because both of its sides are outside.
  Exterior,
  /// The piece stays uncut: nothing tells which parts of a sheet to drop, and cut sheets would only
  /// touch.
  OfSheet,
};

/// Decides which pieces bound the solid that the faces enclose.
///
/// In closed components, the solid is the region with a winding number of at least one, exactly. In
/// others that nearly bound a solid, it is the region with a winding number of about one, by
/// estimates. Sheets are left as they are.
///
/// @param is_cut  #components: non-zero for those whose pieces are to be selected.
/// @return        #pieces.
[[nodiscard]] std::vector<PieceFate> select_pieces(const ArrangedSoup& arranged,
                                                   std::span<const std::uint8_t> is_cut,
                                                   Pockets pockets);

}  // namespace meshalyzer
