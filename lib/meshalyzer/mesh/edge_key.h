#pragma once

#include "meshalyzer/base/types.h"

#include <algorithm>
#include <cstdint>

namespace meshalyzer {

/// Returns a number that is the same for both directions of an edge, and another one for each edge.
/// Edges that are sorted by it are sorted by their lower vertex, then by their higher one.
///
/// @param a, b  The ends.
[[nodiscard]] constexpr std::uint64_t edge_key(Index a, Index b) {
  return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
}

}  // namespace meshalyzer
