#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/set/set_analysis.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// Judges a set. It is good if all its meshes could be read and are good and, if that was
/// requested, no two of them intersect and none is inside another one, not even some of its
/// components.
///
/// @return Nothing if the meshes were not judged.
[[nodiscard]] std::optional<Goodness> set_verdict(const SetAnalysis& set);

/// Appends a phrase each on the meshes of a set that are not good and the files that cannot be
/// read.
void append_reasons_within(std::size_t n_not_good, std::size_t n_unreadable,
                           std::vector<std::string>& reasons);

/// Appends a phrase for each fault between the meshes of a set.
void append_reasons_between(const SetIntersections& found, std::vector<std::string>& reasons);

}  // namespace meshalyzer
