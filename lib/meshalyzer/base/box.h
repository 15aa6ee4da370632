#pragma once

#include "meshalyzer/base/types.h"

namespace meshalyzer {

/// Returns the middle of a box. Halves are added, because the sum of its coordinates may overflow.
[[nodiscard]] inline Vec3 middle_of(const Box3& box) {
  return box.min() / 2 + box.max() / 2;
}

/// Returns half the widths of a box. Halves are subtracted, because the difference may overflow.
[[nodiscard]] inline Vec3 half_widths_of(const Box3& box) {
  return box.max() / 2 - box.min() / 2;
}

/// Returns a box grown by a distance on all sides, up to rounding.
[[nodiscard]] inline Box3 grown(const Box3& box, double by) {
  return {box.min() - Vec3::Constant(by), box.max() + Vec3::Constant(by)};
}

}  // namespace meshalyzer
