#pragma once

#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace meshalyzer {

/// The value that means no limit on a number of pairs.
inline constexpr std::size_t kAllPairs = std::numeric_limits<std::size_t>::max();

/// The limits of a search for intersecting pairs. Memory grows with the listed pairs, not with
/// those found.
struct PairLimits {
  /// The search ends when it has found this many pairs.
  std::size_t max_found = kAllPairs;
  /// The largest number of pairs that are listed: the first ones by their lower face, then by their
  /// higher one.
  std::size_t max_listed = kAllPairs;
  /// The search ends when it has tested this many pairs of faces one by one, found or not.
  std::size_t max_tested = kAllPairs;
  /// The search calls this now and then, from any thread, and ends when it returns true.
  StopQuery wants_to_stop;
};

/// The result of a search for intersecting pairs.
struct FoundPairs {
  /// The first pairs, at most PairLimits::max_listed, ascending by face_a, then face_b.
  std::vector<IntersectingPair> listed;
  /// The numbers of all pairs found, listed or not.
  ContactCounts counts;
  /// Tells whether the search was complete, so that these are all pairs.
  bool is_complete = true;
};

}  // namespace meshalyzer
