#pragma once

#include "meshalyzer/arrangement/windings.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// What becomes of pockets that faces go round the wrong way, as where a surface has been pushed
/// through itself.
enum class Pockets : std::uint8_t {
  Dropped,
  Kept,
  /// They are dropped, and need not be missed: they bound none of the solid.
  Forgotten,
};

/// What becomes of a piece of an arrangement.
enum class PieceFate : std::uint8_t {
  /// It stays as it is.
  Kept,
  /// It stays, turned over.
  Turned,
  /// It goes, because what is on both sides of it is inside the solid.
  Interior,
  /// It goes, because its faces cancel each other out.
  Cancelled,
  /// It goes, because what is on both sides of it is outside.
  Exterior,
  /// It stays uncut: nothing tells what of a sheet should go, and cut sheets would only touch.
  OfSheet,
};

/// Decides which pieces bound the solid that the faces enclose.
///
/// In closed components it is what they go round at least once, by exact winding numbers. Of others
/// that nearly bound a solid it is what they go round about once, by estimates. Sheets are not
/// selected from.
///
/// @param is_cut  #components: non-zero for those that are to be selected from.
/// @return        #pieces.
[[nodiscard]] std::vector<PieceFate> select_pieces(const ArrangedSoup& arranged,
                                                   std::span<const std::uint8_t> is_cut,
                                                   Pockets pockets);

}  // namespace meshalyzer
