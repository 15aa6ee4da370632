#pragma once

#include "meshalyzer/base/hash.h"

#include <cstdint>

namespace meshalyzer {

/// Mixes a vertex, by its key and position, into a hash.
[[nodiscard]] inline std::uint64_t hash_vertex(std::uint64_t hash, Index key,
                                               const Vec3& position) {
  return mix_hash(mix_hash(hash, key), hash_position(position));
}

}  // namespace meshalyzer
