#pragma once

#include "meshalyzer/mesh/soup.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// Finds the vertices that no face uses. A record that repeats an id is none: its vertex is the one
/// that the first record defines.
///
/// @param repeated  The vertex records that repeat an id: see find_repeated_ids().
/// @return          The records, ascending.
/// @complexity      O(#V + #F).
[[nodiscard]] std::vector<Index> find_orphan_vertices(const Soup& soup,
                                                      std::span<const Index> repeated);

}  // namespace meshalyzer
