#pragma once

#include "meshalyzer/repair/passes.h"

#include <vector>

namespace meshalyzer {

/// Returns a face for each triangle of a patch for each loop that may be filled, even if patches
/// intersect the mesh or each other. They have no new vertices.
[[nodiscard]] std::vector<Edits::AddedFace> crossing_patches(const PassInput& input,
                                                             const FillOptions& options);

}  // namespace meshalyzer
