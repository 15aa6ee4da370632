#pragma once

#include "meshalyzer/exact/predicates.h"

namespace meshalyzer {

/// Tells to which side of the plane through a, b, c a direction points: 1 to the side of the normal
/// (b-a) x (c-a), -1 to the other, 0 along the plane (or when a, b, c are collinear, or the
/// direction is zero).
///
/// The answer is exact for all finite doubles: the sign of the dot product of the direction and the
/// normal.
[[nodiscard]] Sign facing(const Vec3& direction, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace meshalyzer
