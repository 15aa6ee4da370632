#pragma once

#include "meshalyzer/base/types.h"

namespace meshalyzer {

/// Returns the distance between two boxes, to rounding; 0 where they meet.
[[nodiscard]] double distance(const Box3& a, const Box3& b);

}  // namespace meshalyzer
