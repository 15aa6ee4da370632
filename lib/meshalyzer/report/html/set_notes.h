#pragma once

#include "meshalyzer/set/set_analysis.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// Returns for each mesh its relations to the others of its set, in words: "intersects b.mesh,
/// c.mesh", "inside b.mesh", "partly inside b.mesh". Only the first few of a long list are named.
[[nodiscard]] std::vector<std::vector<std::string>> set_notes(const SetAnalysis& set);

}  // namespace meshalyzer
