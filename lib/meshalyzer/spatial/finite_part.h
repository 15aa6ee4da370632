#pragma once

#include "meshalyzer/base/types.h"

#include <limits>

namespace meshalyzer {

/// Returns a box whose infinite ends are at the largest doubles instead, so that its middle and its
/// width can be computed. All points of a mesh are on the same side of them.
[[nodiscard]] inline Box3 finite_part(const Box3& box) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  return {box.min().cwiseMax(-kLargest).cwiseMin(kLargest),
          box.max().cwiseMax(-kLargest).cwiseMin(kLargest)};
}

}  // namespace meshalyzer
