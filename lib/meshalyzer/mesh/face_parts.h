#pragma once

#include "meshalyzer/base/types.h"

#include <span>

namespace meshalyzer {

/// A partition of the mesh's faces, for measures that are wanted for each part; only refers to its
/// data.
struct FaceParts {
  /// #mesh faces: the part of each, 0 ... count - 1, or kNoIndex for a face that is in none.
  std::span<const Index> of_face;
  std::size_t count = 0;
};

}  // namespace meshalyzer
