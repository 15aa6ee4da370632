#pragma once

#include "meshalyzer/set/set_analysis.h"

#include <cstddef>

namespace meshalyzer {

/// Returns the intersections sorted as SetIntersections requires, with only the first pairs.
///
/// @param max_list  See MeshRequest.
[[nodiscard]] SetIntersections in_order(SetIntersections found, std::size_t max_list);

/// Appends intersections that in_order() will sort, but drops pairs that will not be among the
/// first.
void append_intersections(const SetIntersections& more, std::size_t max_list,
                          SetIntersections& all);

}  // namespace meshalyzer
