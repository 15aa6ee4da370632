#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/analysis/analyze.h"

namespace meshalyzer {

/// Judges whether a mesh is good (contract 3, -g).
[[nodiscard]] Goodness judge(const Analysis& analysis, const GoodnessThresholds& thresholds);

}  // namespace meshalyzer
