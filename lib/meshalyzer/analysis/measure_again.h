#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/mesh/soup.h"

namespace meshalyzer {

/// Returns the values that the statistics of a mesh are of, and nothing else: where its analysis is
/// known from an earlier run, but the statistics of its set need them. The same values in the same
/// order as Analysis::values.
[[nodiscard]] MeasuredValues measure_again(const Soup& soup);

}  // namespace meshalyzer
