#pragma once

#include "meshalyzer/base/types.h"

#include <cstddef>
#include <utility>

namespace meshalyzer {

/// Two faces with what they have in common moved to the front, in the same order, as
/// find_contact() wants them.
struct AlignedFaces {
  Triangle p;
  Triangle q;
  std::size_t n_common = 0;
};

/// @param same  Whether two vertices count as one.
template <typename Same>
[[nodiscard]] AlignedFaces align_faces(Triangle p, Triangle q, Same&& same) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = n; j < 3; ++j) {
      if (!same(p[i], q[j])) continue;
      std::swap(p[n], p[i]);
      std::swap(q[n], q[j]);
      ++n;
      break;
    }
  }
  return {p, q, n};
}

}  // namespace meshalyzer
