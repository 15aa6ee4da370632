#pragma once

#include "meshalyzer/set/set_analysis.h"

#include <optional>

namespace meshalyzer {

/// Whether a set is good: all its meshes could be read and are good, and, where that was asked for,
/// no two of them intersect and none is inside another one, not even some of its components.
/// @return nothing where the meshes were not judged (-a).
[[nodiscard]] std::optional<bool> is_good(const SetAnalysis& set);

}  // namespace meshalyzer
