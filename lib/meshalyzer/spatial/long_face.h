#pragma once

#include "meshalyzer/base/corners.h"

#include <algorithm>

namespace meshalyzer {

/// A face is long if its longest edge is this many times longer than the altitude on it. Bundles of
/// such faces, oblique to the axes, are what boxes along the axes fit badly.
inline constexpr float kLong = 8.0F;

/// Tells whether a face is long and thin. Squares that overflow make no face long.
[[nodiscard]] inline bool is_long_face(const Corners& face) {
  const Vec3 u = face[1] - face[0];
  const Vec3 v = face[2] - face[0];
  const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
  return longest * longest > double{kLong} * kLong * u.cross(v).squaredNorm();
}

}  // namespace meshalyzer
