#pragma once

#include "meshalyzer/spatial/triangle_contact.h"

#include <optional>
#include <span>

namespace meshalyzer {

/// Bounds the distance of the farthest point of a face from triangles that it was cut into.
///
/// Each point of the face that is deeper inside than the parts are inaccurate lies below as many
/// parts, by projection along its normal, as its incentre does: the sum of the parts' boundaries is
/// a cycle near the face's border, and so winds equally often round all of them.
///
/// @return     The bound, which is as small as the parts' corners are near to the face; nothing
/// where it is not known that the parts cover the face.
/// @complexity O(n log n) for n parts.
[[nodiscard]] std::optional<double> distance_from_parts(const Corners& face,
                                                        std::span<const Corners> parts);

}  // namespace meshalyzer
