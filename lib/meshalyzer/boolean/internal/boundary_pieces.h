#pragma once

#include "meshalyzer/arrangement/arranged_soup.h"
#include "meshalyzer/boolean/inside_rule.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// A piece of the boundary of a solid.
struct BoundaryPiece {
  Index piece = kNoIndex;
  /// The face of the soup that it is a part of; if several cover it, the first with the same
  /// orientation.
  Index face = kNoIndex;
  /// Tells whether the solid is in front of the piece, so that it must be reversed.
  bool is_turned = false;
};

/// Finds the boundary of the cells that are inside by a rule: the result of a boolean operation
/// before anything is rounded.
///
/// @param arranged    The soup, cut along its intersections. Its faces have an area, and those of
///     each operand cross every edge equally often in both directions.
/// @param operand_of  #faces, each below n_operands.
/// @return            The pieces, in their order in the arrangement.
[[nodiscard]] std::vector<BoundaryPiece> find_boundary_pieces(const ArrangedSoup& arranged,
                                                              std::span<const Index> operand_of,
                                                              std::size_t n_operands,
                                                              const InsideRule& rule);

}  // namespace meshalyzer
