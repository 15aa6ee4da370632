#pragma once

#include "meshalyzer/arrangement/clusters.h"
#include "meshalyzer/base/stop_query.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// Finds the points inside the segments of a cluster where they cross each other.
///
/// Segments on edges of faces are skipped: their crossings are already known from pairs of faces.
///
/// @param max_found      Once more are found than this, the search ends.
/// @param wants_to_stop  Called now and then; once it returns true, the result means nothing.
/// @complexity  O(n log n + pairs whose boxes meet).
[[nodiscard]] std::vector<PointName> find_segment_crossings(std::span<const FaceSimplex> simplices,
                                                            const FaceCluster& cluster,
                                                            const NamedPoints& points,
                                                            std::size_t max_found,
                                                            const StopQuery& wants_to_stop);

}  // namespace meshalyzer
