#pragma once

#include "meshalyzer/set/set_analysis.h"

#include <cstddef>

namespace meshalyzer {

/// Returns the intersections sorted as SetIntersections promises, and of the pairs the first.
///
/// @param max_list  See MeshRequest.
[[nodiscard]] SetIntersections in_order(SetIntersections found, std::size_t max_list);

/// Appends intersections that are still to be put in order, but drops pairs that will not be among
/// the first.
void append_intersections(const SetIntersections& more, std::size_t max_list,
                          SetIntersections& all);

}  // namespace meshalyzer
