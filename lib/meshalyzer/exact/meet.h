#pragma once

#include "meshalyzer/exact/exact_point.h"

#include <array>

namespace meshalyzer {

/// Two points of a line.
using LinePoints = std::array<Vec3, 2>;
/// Three points of a plane, not in one line.
using PlanePoints = std::array<Vec3, 3>;

/// Returns the one point that a line and a plane have in common: they must not be parallel.
[[nodiscard]] ExactPoint meet(const LinePoints& line, const PlanePoints& plane);

/// Returns the one point that two lines of one plane have in common. In the projection along
/// `dropped` they must not be parallel.
[[nodiscard]] ExactPoint meet(const LinePoints& p, const LinePoints& q, Axis dropped);

/// Returns the one point that three planes have in common: no two of them, nor their common lines,
/// may be parallel.
[[nodiscard]] ExactPoint meet(const PlanePoints& p, const PlanePoints& q, const PlanePoints& r);

}  // namespace meshalyzer
