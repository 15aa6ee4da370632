#pragma once

#include "meshalyzer/spatial/intersecting_pair.h"
#include "meshalyzer/spatial/nesting.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// The numbers of the intersecting pairs of a mesh: of all pairs that the search has found, listed
/// or not.
struct IntersectionCounts {
  ContactCounts kinds;
  /// #mesh faces: non-zero for faces that intersect another one.
  std::vector<std::uint8_t> intersects;
  /// #components: the number of pairs with at least one face in each.
  std::vector<std::size_t> of_component;
  /// The pairs of components that intersect, as find_nesting() needs them.
  std::vector<PartContact> contacts;
  /// Tells whether all pairs were found; else the counts are lower bounds (see PairLimits).
  bool is_complete = true;
};

}  // namespace meshalyzer
