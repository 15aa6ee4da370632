#pragma once

#include "meshalyzer/base/types.h"

#include <array>
#include <span>
#include <vector>

namespace meshalyzer {

/// An edge of a face.
struct FaceEdge {
  /// The lower end first.
  std::array<Index, 2> ends{};
  Index face = kNoIndex;
  /// 1 if the face goes round from the lower end to the other, else -1.
  int sign = 1;
};

/// Returns the edges of faces, those with the same ends one after the other, by face.
///
/// @complexity  O(n log n).
[[nodiscard]] std::vector<FaceEdge> sorted_edges(std::span<const Triangle> faces);

}  // namespace meshalyzer
