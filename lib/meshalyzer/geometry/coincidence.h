#pragma once

#include "meshalyzer/base/types.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// The criterion by which two vertices are at the same place.
enum class Coincidence : std::uint8_t {
  /// Every coordinate differs by at most 1e-10 max(1, |a|, |b|).
  Tolerant,
  /// Every coordinate is equal (0.0 equals -0.0).
  Exact,
};

/// Tells whether two positions are at the same place. The relation is symmetric and reflexive; with
/// Coincidence::Tolerant it is not transitive.
///
/// @param a, b  Finite.
[[nodiscard]] bool is_indistinguishable(const Vec3& a, const Vec3& b, Coincidence coincidence);

/// Finds the vertices that have at least one other vertex at the same place.
///
/// @param positions  Finite; fewer than 2^31.
/// @return           Their indices, ascending.
/// @complexity       O(n log n) time for any distribution of the points, even if thousands share
///                   coordinates or all are within the tolerance; O(n) memory.
[[nodiscard]] std::vector<Index> find_indistinguishable_vertices(std::span<const Vec3> positions,
                                                                 Coincidence coincidence);

}  // namespace meshalyzer
