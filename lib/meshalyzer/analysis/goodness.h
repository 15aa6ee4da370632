#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/analysis/analyze.h"

namespace meshalyzer {

/// Judges the parts of goodness that need no threshold (contract 3, -g and -s).
[[nodiscard]] Goodness judge_fitness(const Analysis& analysis);

/// Judges whether a mesh is good (contract 3, -g).
[[nodiscard]] Goodness judge(const Analysis& analysis, const GoodnessThresholds& thresholds);

}  // namespace meshalyzer
