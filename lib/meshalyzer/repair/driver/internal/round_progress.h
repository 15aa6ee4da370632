#pragma once

#include "meshalyzer/defects/defect.h"
#include "meshalyzer/repair/driver/internal/repair_state.h"

#include <array>
#include <cstddef>
#include <limits>

namespace meshalyzer {

/// Tells whether the rounds of a repair still make progress. Passes may undo each other's work: one
/// parts what touches, and another joins it again while it repairs what the first has left.
class RoundProgress {
 public:
  RoundProgress() { fewest_.fill(std::numeric_limits<std::size_t>::max()); }

  /// Notes the mesh that a round has left.
  void note(const RepairState& state);

  /// Returns the number of rounds since the last one that left fewer intersecting pairs than all
  /// before it, or fewer defective elements of a kind.
  [[nodiscard]] std::size_t n_rounds_without() const { return n_rounds_without_; }

 private:
  /// The fewest that a round has left, by code; the last is that of the intersecting pairs.
  std::array<std::size_t, kDefectCodes + 1> fewest_;
  std::size_t n_rounds_without_ = 0;
};

}  // namespace meshalyzer
