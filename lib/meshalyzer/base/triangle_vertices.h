#pragma once

#include "meshalyzer/base/types.h"

#include <algorithm>

namespace meshalyzer {

/// Tells whether a vertex is a corner of a face.
[[nodiscard]] inline bool has_corner(const Triangle& t, Index vertex) {
  return std::find(t.begin(), t.end(), vertex) != t.end();
}

/// Returns a face with one vertex in the place of another.
[[nodiscard]] inline Triangle with_corner(Triangle t, Index old, Index vertex) {
  std::replace(t.begin(), t.end(), old, vertex);
  return t;
}

}  // namespace meshalyzer
