#pragma once

#include "meshalyzer/mesh/soup.h"

#include <array>
#include <vector>

namespace meshalyzer {

// Private to the defects module: where to look for an element.

/// Halves are added, so that nothing overflows.
[[nodiscard]] inline Vec3 middle_of_edge(const Soup& soup, const std::array<Index, 2>& ends) {
  return soup.positions[ends[0]] / 2 + soup.positions[ends[1]] / 2;
}

/// The mean of the corners that there are; nothing where no record defines any of them.
[[nodiscard]] std::vector<Vec3> middle_of_face(const Soup& soup, Index face);

}  // namespace meshalyzer
