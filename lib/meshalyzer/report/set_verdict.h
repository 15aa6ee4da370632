#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/set/set_analysis.h"

#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// Judges a set: it is good where all its meshes could be read and are good, and, where that was
/// asked for, no two of them intersect and none is inside another one, not even some of its
/// components.
///
/// @return Nothing where the meshes were not judged (-a).
[[nodiscard]] std::optional<Goodness> set_verdict(const SetAnalysis& set);

/// Appends what is wrong between the meshes of a set, a phrase each.
void append_reasons_between(const SetIntersections& found, std::vector<std::string>& reasons);

}  // namespace meshalyzer
