#pragma once

#include "meshalyzer/analysis/analysis.h"

namespace meshalyzer {

/// Tells whether a list of the edges or faces beyond a threshold was asked for: such a list is
/// reported even where no other offenders are.
[[nodiscard]] inline bool has_asked_lists(const Offenders& all) {
  return all.short_edges || all.long_edges || all.small_angles || all.large_angles ||
         all.large_aspect_ratios;
}

}  // namespace meshalyzer
