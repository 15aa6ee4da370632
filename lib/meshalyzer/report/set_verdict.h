#pragma once

#include "meshalyzer/set/set_analysis.h"

#include <optional>

namespace meshalyzer {

/// Tells whether a set is good: whether all its meshes could be read and are good, and, where that
/// was asked for, no two of them intersect and none is inside another one, not even some of its
/// components.
/// @return Nothing where the meshes were not judged.
[[nodiscard]] std::optional<bool> is_good(const SetAnalysis& set);

}  // namespace meshalyzer
