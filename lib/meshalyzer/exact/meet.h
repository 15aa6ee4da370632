#pragma once

#include "meshalyzer/exact/exact_point.h"

#include <array>

namespace meshalyzer {

/// Two points of a line.
using LinePoints = std::array<Vec3, 2>;
/// Three points of a plane, not collinear.
using PlanePoints = std::array<Vec3, 3>;

/// Returns the intersection of a line and a plane, which must not be parallel.
[[nodiscard]] ExactPoint meet(const LinePoints& line, const PlanePoints& plane);

/// Returns the intersection of two coplanar lines, which must not be parallel in the projection
/// along `dropped`.
[[nodiscard]] ExactPoint meet(const LinePoints& p, const LinePoints& q, Axis dropped);

/// Returns the intersection of three planes; no two of them may be parallel, nor two of the lines
/// in which they meet.
[[nodiscard]] ExactPoint meet(const PlanePoints& p, const PlanePoints& q, const PlanePoints& r);

}  // namespace meshalyzer
