#pragma once

#include "meshalyzer/mesh/soup.h"

#include <map>
#include <string>

namespace meshalyzer {

/// Counts by name: "border edges", ...
using PlainCounts = std::map<std::string, std::size_t>;

/// Counts what is wrong with a mesh in the plainest way, from its records and without half-edges:
/// to be compared with what the library finds by better ways.
[[nodiscard]] PlainCounts count_plainly(const Soup& soup);

}  // namespace meshalyzer
