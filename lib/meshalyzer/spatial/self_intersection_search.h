#pragma once

#include "meshalyzer/spatial/pair_limits.h"
#include "meshalyzer/spatial/pair_listener.h"
#include "meshalyzer/spatial/self_intersection_scene.h"

namespace meshalyzer {

/// Passes the pairs with at least one wanted face, each once, with its kind, to a listener. They
/// are the same for any number of threads, unless the search was told to stop.
///
/// @param limits  The limits of the search; if max_found ends it, it finds that many or a few more,
///                if max_tested does, it tests at most that many and those of some thousand leaves.
/// @return        True if the search was complete.
bool search_self_intersections(const SelfIntersectionScene& scene, const PairLimits& limits,
                               PairListener& listener);

}  // namespace meshalyzer
