#pragma once

#include "meshalyzer/base/types.h"

#include <array>
#include <cstddef>
#include <utility>

namespace meshalyzer {

/// Two faces whose common corners have been moved to the front, in the same order, as
/// find_contact() wants them. A corner is anything that names one: a vertex, a position, a number.
template <typename Corner>
struct AlignedFaces {
  std::array<Corner, 3> p;
  std::array<Corner, 3> q;
  std::size_t n_common = 0;
};

/// Aligns two faces.
///
/// @param same  Tells whether a corner of the first and one of the second count as one.
template <typename Corner, typename Same>
[[nodiscard]] AlignedFaces<Corner> align_faces(std::array<Corner, 3> p, std::array<Corner, 3> q,
                                               Same&& same) {
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
