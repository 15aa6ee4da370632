#pragma once

#include "meshalyzer/exact/predicates.h"

namespace meshalyzer {

/// Tells whether a direction points to the side of the plane through a, b, c that the normal (b-a)
/// x (c-a) points to: 1 if so, -1 where it points to the other, 0 along the plane (or when a, b, c
/// are collinear, or the direction is zero).
///
/// Exact for all finite doubles: the sign of the dot product of the direction and the normal.
[[nodiscard]] Sign facing(const Vec3& direction, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace meshalyzer
