#pragma once

#include "meshalyzer/spatial/pair_collector.h"
#include "meshalyzer/spatial/self_intersection_scene.h"

#include <cstddef>

namespace meshalyzer {

/// Returns the lanes of a leaf whose faces are wanted.
[[nodiscard]] unsigned wanted_lanes(const SelfIntersectionScene& scene, std::size_t leaf);

/// Finds the pairs of the wanted faces of one leaf. Wanted partners that come earlier are skipped:
/// they have found the pair themselves.
///
/// @param found  The buffer that the pairs are pushed to.
/// @return       The number of pairs of faces that were tested one by one.
std::size_t find_partners(const SelfIntersectionScene& scene, std::size_t leaf, PairBuffer& found);

}  // namespace meshalyzer
