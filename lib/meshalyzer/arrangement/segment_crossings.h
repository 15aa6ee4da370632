#pragma once

#include "meshalyzer/arrangement/clusters.h"

namespace meshalyzer {

/// Finds the points inside the segments of a cluster where they cross each other.
///
/// Segments on edges of faces are skipped: their crossings are already known from pairs of faces.
///
/// @complexity  O(n log n + pairs whose boxes meet).
[[nodiscard]] std::vector<PointName> find_segment_crossings(std::span<const FaceSimplex> simplices,
                                                            const FaceCluster& cluster,
                                                            const NamedPoints& points);

}  // namespace meshalyzer
