#pragma once

#include "meshalyzer/arrangement/arranged_soup.h"
#include "meshalyzer/boolean/inside_rule.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// Finds the cells of an arrangement that are inside the result of a boolean operation: winding
/// numbers by operand come from one exact ray for each component, and from there across the pieces.
///
/// @param arranged    Of closed components alone.
/// @param operand_of  #faces, each below n_operands.
/// @return            #cells, 1 for those that are inside.
/// @complexity        O(#pieces + #cells n_operands), and what the rays take.
[[nodiscard]] std::vector<std::uint8_t> find_inside_cells(const ArrangedSoup& arranged,
                                                          std::span<const Index> operand_of,
                                                          std::size_t n_operands,
                                                          const InsideRule& rule);

}  // namespace meshalyzer
