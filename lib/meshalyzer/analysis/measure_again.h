#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/mesh/soup.h"

namespace meshalyzer {

/// Returns only the values from which the statistics of a mesh are computed, the same in the same
/// order as Analysis::values. The statistics of a set need them when the analysis of the mesh is
/// known from an earlier run.
///
/// @throws InvalidArgument  as build(); and if a position is not finite.
[[nodiscard]] MeasuredValues measure_again(const Soup& soup);

}  // namespace meshalyzer
