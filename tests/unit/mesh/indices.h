#pragma once

#include "meshalyzer/base/types.h"

#include <vector>

namespace meshalyzer {

using Indices = std::vector<Index>;

/// Returns the indices of a range of OpenMesh handles.
template <typename Range>
[[nodiscard]] Indices indices(Range&& range) {
  Indices result;
  for (const auto& handle : range) result.push_back(static_cast<Index>(handle.idx()));
  return result;
}

}  // namespace meshalyzer
