#pragma once

#include "meshalyzer/mesh/soup.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

/// Returns a face with one of its corners first, in the same cyclic order.
[[nodiscard]] inline Triangle with_first(Triangle t, Index corner) {
  std::rotate(t.begin(), std::find(t.begin(), t.end(), corner), t.end());
  return t;
}

/// Orders the faces round a vertex.
///
/// @param faces  Those without the vertex are left out.
/// @return  By number, the faces that have the vertex, in the order in which they surround it
///          counter-clockwise, that with the lowest next corner first; nothing if they are fewer
///          than three, or not one closed fan of one orientation.
/// @complexity O(n log n).
[[nodiscard]] std::optional<std::vector<Index>> closed_fan(std::span<const Triangle> faces,
                                                           Index vertex);

}  // namespace meshalyzer
