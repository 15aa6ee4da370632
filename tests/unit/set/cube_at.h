#pragma once

#include "support/shapes.h"

namespace meshalyzer {

/// A cube whose lowest corner has this number for all its coordinates.
[[nodiscard]] inline Soup cube_at(double low, double side) {
  return shapes::cube(side, Vec3::Constant(low));
}

}  // namespace meshalyzer
