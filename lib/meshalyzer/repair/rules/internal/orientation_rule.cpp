#include "meshalyzer/repair/rules/internal/orientation_rule.h"

#include "meshalyzer/exact/predicates.h"

namespace meshalyzer {

bool keeps_orientation(const Corners& before, const Corners& after) {
  const auto axis = projection_axis(before[0], before[1], before[2]);
  return !axis || orient2d(*axis, before[0], before[1], before[2]) ==
                      orient2d(*axis, after[0], after[1], after[2]);
}

}  // namespace meshalyzer
