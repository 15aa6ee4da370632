#pragma once

#include "meshalyzer/base/types.h"

#include <cstddef>
#include <span>

namespace meshalyzer {

/// A partition of the faces of a mesh, for measures of each part. It only refers to its data.
struct FaceParts {
  /// #mesh faces: the part of each, 0 ... count - 1, or kNoIndex for a face in no part.
  std::span<const Index> of_face;
  std::size_t count = 0;
};

}  // namespace meshalyzer
