#pragma once

#include "meshalyzer/spatial/intersecting_pair.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace meshalyzer {

/// As many pairs as there are.
inline constexpr std::size_t kAllPairs = std::numeric_limits<std::size_t>::max();

/// Tells how far a search for intersecting pairs goes, and how many of those it finds it lists.
/// Memory follows the list, not what is found.
struct PairLimits {
  /// The search ends when it has found so many.
  std::size_t max_found = kAllPairs;
  /// At most so many pairs are listed: the first ones by their lower face, then by their higher.
  std::size_t max_listed = kAllPairs;
  /// Asked now and then, by any thread: the search ends when it returns true. None: never.
  std::function<bool()> wants_to_stop;
};

/// What a search for intersecting pairs has found.
struct FoundPairs {
  /// Ascending by face_a, then face_b: the first ones, at most PairLimits::max_listed.
  std::vector<IntersectingPair> listed;
  /// All that were found, listed or not.
  ContactCounts counts;
  /// Tells whether the search went to its end, so that these are all there are.
  bool is_complete = true;
};

}  // namespace meshalyzer
