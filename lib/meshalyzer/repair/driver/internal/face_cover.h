#pragma once

#include "meshalyzer/spatial/triangle_contact.h"

#include <optional>
#include <span>

namespace meshalyzer {

/// Bounds the distance of the farthest point of a face from triangles that it was cut into.
///
/// Each point of the face that is deeper inside than the inaccuracy of the parts lies below as many
/// parts, by projection along its normal, as its incentre does: the sum of the parts' boundaries is
/// a cycle near the face's border, and so has the same winding number round all of these points,
/// which is the number of parts above or below them.
///
/// @param slack  Corners of parts that are nearer to each other than this count as one, and an edge
/// counts as passing through corners that are nearer to it; the bound grows by their distances. At
/// least 0.
/// @return     The bound, which is as small as the parts' corners are near to the face; nothing if
/// the parts are not proved to cover the face.
/// @complexity O(n log n) for n parts with distinct corners; with a slack, O(k^2) for the k edges,
/// at most 1,000, that do not cancel.
[[nodiscard]] std::optional<double> distance_from_parts(const Corners& face,
                                                        std::span<const Corners> parts,
                                                        double slack = 0.0);

}  // namespace meshalyzer
