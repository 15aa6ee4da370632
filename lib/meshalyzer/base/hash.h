#pragma once

#include "meshalyzer/base/types.h"

#include <bit>
#include <cstdint>

namespace meshalyzer {

/// Mixes the bits of a number into a hash.
[[nodiscard]] constexpr std::uint64_t mix_hash(std::uint64_t hash, std::uint64_t number) {
  hash = (hash ^ number) * 0x9E3779B97F4A7C15U;
  return hash ^ (hash >> 32U);
}

/// Hashes a position; positions that compare equal have the same hash, also where one coordinate is
/// 0.0 and the other -0.0.
[[nodiscard]] inline std::uint64_t hash_position(const Vec3& position) {
  std::uint64_t hash = 0;
  // Adding 0.0 turns -0.0 into 0.0 and changes nothing else.
  for (const double x : position) hash = mix_hash(hash, std::bit_cast<std::uint64_t>(x + 0.0));
  return hash;
}

}  // namespace meshalyzer
