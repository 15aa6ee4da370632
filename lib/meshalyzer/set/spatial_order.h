#pragma once

#include "meshalyzer/base/types.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// The objects in an order in which neighbours in space mostly follow each other: along a Z-order
/// curve through the centres of their boxes (Morton 1966).
///
/// @param boxes  One an object; objects with an empty box are left out.
/// @complexity   O(n log n).
[[nodiscard]] std::vector<Index> order_in_space(std::span<const Box3> boxes);

/// For each object the other ones whose boxes share a point with its own, ascending.
///
/// @complexity O(n log n + pairs whose boxes meet along the axis that parts them best).
[[nodiscard]] std::vector<std::vector<Index>> find_meeting_boxes(std::span<const Box3> boxes);

/// The distance between two boxes, to rounding; 0 where they meet.
[[nodiscard]] double distance(const Box3& a, const Box3& b);

}  // namespace meshalyzer
