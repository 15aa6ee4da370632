#pragma once

#include "meshalyzer/base/types.h"

namespace meshalyzer {

/// Returns the distance between two boxes, up to rounding; 0 if they meet.
[[nodiscard]] double distance(const Box3& a, const Box3& b);

}  // namespace meshalyzer
