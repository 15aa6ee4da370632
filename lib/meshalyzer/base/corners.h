#pragma once

#include "meshalyzer/base/types.h"

#include <array>

namespace meshalyzer {

/// The corners of a triangle in space, possibly of zero area.
using Corners = std::array<Vec3, 3>;

}  // namespace meshalyzer
