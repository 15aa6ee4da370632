#pragma once

#include "meshalyzer/mesh/soup.h"

#include <array>
#include <vector>

namespace meshalyzer {

/// Returns the midpoint of an edge as a sum of halves, so that nothing overflows.
[[nodiscard]] inline Vec3 middle_of_edge(const Soup& soup, const std::array<Index, 2>& ends) {
  return soup.positions[ends[0]] / 2 + soup.positions[ends[1]] / 2;
}

/// Returns the mean of the defined corners, or nothing if none is defined.
[[nodiscard]] std::vector<Vec3> middle_of_face(const Soup& soup, Index face);

}  // namespace meshalyzer
