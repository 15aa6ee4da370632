#pragma once

#include "meshalyzer/base/types.h"

#include <array>
#include <span>

namespace meshalyzer {

/// The corners of a triangle in space, possibly of zero area.
using Corners = std::array<Vec3, 3>;

/// Returns the corners of a triangle whose vertices are numbers of points.
[[nodiscard]] inline Corners corners_of(std::span<const Vec3> points, const Triangle& t) {
  return {points[t[0]], points[t[1]], points[t[2]]};
}

}  // namespace meshalyzer
