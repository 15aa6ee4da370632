#pragma once

#include "meshalyzer/arrangement/arranged_soup.h"
#include "meshalyzer/boolean/inside_rule.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// Finds the cells of an arrangement that are inside the result of a boolean operation: the winding
/// numbers come from one exact ray for each component, and are propagated from there across the
/// pieces.
///
/// @param arranged    The arrangement, of closed components only.
/// @param operand_of  #faces, each below n_operands.
/// @return            #cells: 1 for those that are inside.
/// @complexity        O(#pieces + #cells n_operands), plus the cost of the rays.
[[nodiscard]] std::vector<std::uint8_t> find_inside_cells(const ArrangedSoup& arranged,
                                                          std::span<const Index> operand_of,
                                                          std::size_t n_operands,
                                                          const InsideRule& rule);

}  // namespace meshalyzer
