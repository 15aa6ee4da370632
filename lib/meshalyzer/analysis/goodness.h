#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/analysis/analyze.h"

#include <optional>
#include <string>

namespace meshalyzer {

/// Judges the parts of goodness that need no threshold ("Good" in doc/definitions.md).
[[nodiscard]] Goodness judge_fitness(const Analysis& analysis);

/// Judges whether a mesh is good ("Good" in doc/definitions.md).
[[nodiscard]] Goodness judge(const Analysis& analysis, const GoodnessThresholds& thresholds);

/// Returns the verdict of every report: by thresholds if these were given, else without them. It is
/// empty if the mesh was not judged.
[[nodiscard]] const std::optional<Goodness>& verdict_of(const Analysis& analysis);

/// Returns a verdict in words: "good", or "NOT good: " and the reasons.
[[nodiscard]] std::string verdict_text(const Goodness& verdict);

}  // namespace meshalyzer
