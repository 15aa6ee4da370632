#pragma once

#include "meshalyzer/base/types.h"

#include <algorithm>

namespace meshalyzer {

/// Tells whether a vertex is a corner of a face.
[[nodiscard]] inline bool has_corner(const Triangle& t, Index vertex) {
  return std::find(t.begin(), t.end(), vertex) != t.end();
}

/// Returns the corner of a face that is neither of two others.
[[nodiscard]] inline Index third_corner(const Triangle& t, Index a, Index b) {
  return *std::find_if(t.begin(), t.end(), [&](Index v) { return v != a && v != b; });
}

/// Returns a face with one vertex in the place of another.
[[nodiscard]] inline Triangle with_corner(Triangle t, Index old, Index vertex) {
  std::replace(t.begin(), t.end(), old, vertex);
  return t;
}

/// Returns the corners of a face in ascending order, which are equal for faces with the same
/// vertices.
[[nodiscard]] inline Triangle sorted_corners(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// Tells whether two faces have the same corners in the same cyclic order.
[[nodiscard]] inline bool has_same_cycle(Triangle a, const Triangle& b) {
  for (int i = 0; i < 3; ++i) {
    if (a == b) return true;
    std::rotate(a.begin(), a.begin() + 1, a.end());
  }
  return false;
}

}  // namespace meshalyzer
