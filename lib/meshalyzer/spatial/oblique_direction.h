#pragma once

#include "meshalyzer/base/types.h"

namespace meshalyzer {

/// A direction of length 1 that is parallel to no axis, no diagonal and no plane of these. So what
/// is laid along it lies in no plane that models have.
inline const Vec3 kObliqueDirection = Vec3(0.5257, 0.7693, 0.3626).normalized();

}  // namespace meshalyzer
