#pragma once

#include "meshalyzer/mesh/soup.h"

#include <vector>

namespace meshalyzer {

/// Finds the records whose id already belongs to an earlier record.
///
/// @return     The records, ascending; none if the file does not name its ids.
/// @complexity O(n) if ids ascend, else O(n log n).
[[nodiscard]] std::vector<Index> find_repeated_ids(const Ids& ids);

}  // namespace meshalyzer
