#pragma once

#include "meshalyzer/analysis/analysis.h"

namespace meshalyzer {

/// Whether a list of -b ... -f was asked for: such a list is told without -p too.
[[nodiscard]] inline bool has_asked_lists(const Offenders& all) {
  return all.short_edges || all.long_edges || all.small_angles || all.large_angles ||
         all.large_aspect_ratios;
}

}  // namespace meshalyzer
