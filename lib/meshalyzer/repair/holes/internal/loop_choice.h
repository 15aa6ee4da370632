#pragma once

#include "meshalyzer/repair/holes/fill_options.h"
#include "meshalyzer/repair/holes/internal/hole_loop.h"
#include "meshalyzer/repair/pass.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// Tells which loops may be filled; some of the others may still be joined to one of these.
struct LoopChoice {
  std::vector<std::uint8_t> is_chosen;
  std::vector<std::uint8_t> may_join;
  /// 0 for the loops of parts that are known to bound a solid.
  std::vector<std::uint8_t> may_be_sheet;
  std::vector<Refusal> refused;
};

/// Chooses the loops to be filled: none too long, not those of sheets if these are to stay open,
/// and only the nearest to a point if one is given.
[[nodiscard]] LoopChoice choose_loops(const PassInput& input, std::span<const HoleLoop> loops,
                                      const FillOptions& options);

}  // namespace meshalyzer
