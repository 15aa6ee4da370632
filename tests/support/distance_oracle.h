#pragma once

#include "meshalyzer/base/types.h"

#include <array>

namespace meshalyzer::test {

/// Tells whether the true distance from a point to a triangle, over the rationals, is `distance` up
/// to this error. A triangle of zero area is the segment or point that it is.
[[nodiscard]] bool is_rational_distance(double distance, const std::array<Vec3, 3>& corners,
                                        const Vec3& point, double error);

}  // namespace meshalyzer::test
