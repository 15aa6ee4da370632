#pragma once

#include "meshalyzer/base/types.h"

#include <algorithm>

namespace meshalyzer {

/// Orders points by x, then by y, then by z. Collinear points are thereby ordered along their line.
[[nodiscard]] inline bool lexicographically_less(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

}  // namespace meshalyzer
