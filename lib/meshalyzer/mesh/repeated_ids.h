#pragma once

#include "meshalyzer/mesh/soup.h"

#include <vector>

namespace meshalyzer {

/// Finds the records whose id an earlier record has.
///
/// @return     Ascending; none where ids are not named one by one.
/// @complexity O(n) where ids ascend, else O(n log n).
[[nodiscard]] std::vector<Index> find_repeated_ids(const Ids& ids);

}  // namespace meshalyzer
