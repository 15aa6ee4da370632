#pragma once

#include "meshalyzer/base/statistics.h"
#include "meshalyzer/base/types.h"

#include <functional>
#include <span>
#include <vector>

namespace meshalyzer {

/// Summarises values separately for each component.
///
/// @param n             The number of components.
/// @param component_of  The component of value i, kNoIndex if it belongs to none.
/// @return              One summary for each component.
/// @complexity          O(#values + n) time; one copy of the values.
[[nodiscard]] std::vector<Summary> summarize_by_component(
    std::size_t n, std::span<const double> values,
    const std::function<Index(std::size_t)>& component_of);

}  // namespace meshalyzer
