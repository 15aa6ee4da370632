#pragma once

#include "meshalyzer/spatial/intersecting_pair.h"

#include <vector>

namespace meshalyzer {

/// Makes one list of what the chunks of a search have found, ascending by face_a, then face_b. Each
/// part is freed as soon as it is taken over.
[[nodiscard]] std::vector<IntersectingPair> join_pairs(
    std::vector<std::vector<IntersectingPair>> parts);

}  // namespace meshalyzer
