#include "meshalyzer/repair/driver/internal/round_progress.h"

namespace meshalyzer {

void RoundProgress::note(const RepairState& state) {
  std::array<std::size_t, kDefectCodes + 1> counts{};
  for (const DefectiveElement& element : state.defective_elements()) {
    ++counts[static_cast<std::size_t>(element.code)];
  }
  counts.back() = state.mesh().intersecting_pairs().size();
  ++n_rounds_without_;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] >= fewest_[i]) continue;
    fewest_[i] = counts[i];
    n_rounds_without_ = 0;
  }
}

}  // namespace meshalyzer
