#pragma once

#include "support/shapes.h"

#include <algorithm>

namespace meshalyzer {

/// The box from 0 to (1, 3, 1), and within it the one from 0 to (1, 2, 1): five sides of it lie on
/// sides of the other, and the one with y = 0 has the same four vertices. Their union has volume 3.
inline Soup boxes_with_a_common_side() {
  Soup soup = shapes::merged(shapes::box({0, 0, 0}, {1, 3, 1}), shapes::box({0, 0, 0}, {1, 2, 1}));
  for (Triangle& t : soup.triangles) {
    for (Index& v : t) {
      const auto first = std::find(soup.positions.begin(), soup.positions.end(), soup.positions[v]);
      v = static_cast<Index>(first - soup.positions.begin());
    }
  }
  return soup;
}

/// The cube from 0 to 3 with a square hole along z, given as a box that is inside out and reaches
/// from one side of the cube to the other. The volume without the hole is 24.
inline Soup cube_and_hole() {
  return shapes::merged(shapes::cube(3), shapes::flipped(shapes::box({1, 1, 0}, {2, 2, 3})));
}

}  // namespace meshalyzer
