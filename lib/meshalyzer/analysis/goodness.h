#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/analysis/analyze.h"

namespace meshalyzer {

/// Judges the parts of goodness that need no threshold ("Good" in doc/definitions.md).
[[nodiscard]] Goodness judge_fitness(const Analysis& analysis);

/// Judges whether a mesh is good ("Good" in doc/definitions.md).
[[nodiscard]] Goodness judge(const Analysis& analysis, const GoodnessThresholds& thresholds);

}  // namespace meshalyzer
