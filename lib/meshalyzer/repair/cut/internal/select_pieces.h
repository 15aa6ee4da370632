#pragma once

#include "meshalyzer/arrangement/windings.h"
#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/repair/passes.h"

#include <cstdint>
#include <span>
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

struct SelectOptions {
  Pockets pockets = Pockets::Dropped;
  Sheets sheets = Sheets::Left;
  /// Called now and then, from any thread; once it returns true, the selection means nothing.
  StopQuery wants_to_stop = {};
};

/// The decision on a piece of an arrangement.
enum class PieceClass : std::uint8_t {
  /// The piece stays as it is.
  Kept,
  /// The piece stays, turned over.
  Turned,
  /// The piece is dropped, because both of its sides are inside the solid.
  Interior,
  /// The piece is dropped, because its faces cancel each other out.
  Cancelled,
  /// The piece is dropped, because both of its sides are outside, exactly: it is the wall of a
  /// pocket.
  Exterior,
  /// The piece is dropped, because both of its sides are outside, by estimates.
  PerhapsExterior,
  /// The piece stays, though both of its sides are outside: it is part of a sheet.
  OfSheet,
  /// The piece stays uncut: it belongs to sheets, or to solids that they cross, and sheets are
  /// left.
  Uncut,
  /// The piece stays uncut: it belongs to loose faces, which would only become more.
  Loose,
};

/// Decides which pieces bound the solid that the faces enclose.
///
/// In closed components, the solid is the region with a winding number of at least one, exactly. In
/// others that nearly bound a solid, it is the region with a winding number of about one, by
/// estimates. Other components are left, unless sheets are to be cut. Then it is what closed chains
/// of their faces enclose, exactly; the other faces are sheets, which are dropped inside it and
/// stay outside. Faces most of whose edges have no other face are left all the same.
///
/// @param is_cut  #components: non-zero for those whose pieces are to be selected.
/// @return        #pieces.
[[nodiscard]] std::vector<PieceClass> select_pieces(const ArrangedSoup& arranged,
                                                    std::span<const std::uint8_t> is_cut,
                                                    const SelectOptions& options);

}  // namespace meshalyzer
