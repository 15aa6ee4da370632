#pragma once

#include "meshalyzer/spatial/intersecting_pair.h"
#include "meshalyzer/spatial/nesting.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// What the intersecting pairs of a mesh are in numbers: of all pairs that the search has found,
/// whether they are listed or not.
struct IntersectionCounts {
  ContactCounts kinds;
  /// #mesh faces: non-zero for those that intersect another.
  std::vector<std::uint8_t> intersects;
  /// #components: the pairs that have at least one face in each.
  std::vector<std::size_t> of_component;
  /// The pairs of components that intersect, as find_nesting() needs them.
  std::vector<PartContact> contacts;
  /// Tells whether the search was told to stop (PairLimits::wants_to_stop) before its end: then
  /// these are the least that there can be.
  bool was_stopped = false;
};

}  // namespace meshalyzer
