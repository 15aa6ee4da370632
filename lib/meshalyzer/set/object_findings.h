#pragma once

#include "meshalyzer/set/separation.h"
#include "meshalyzer/set/set_analysis.h"

#include <optional>
#include <vector>

namespace meshalyzer {

/// The findings between one mesh of a set, the owner, and the others. Each pair of meshes has one
/// owner: the first in the spatial order.
struct ObjectFindings {
  /// The number of the owner in the set.
  Index owner = 0;
  /// The intersections with all meshes that come later in the spatial order; present if requested.
  std::optional<SetIntersections> intersections;
  /// The separation of the owner's vertices from all others; present if requested.
  std::optional<ObjectSeparation> separation;
};

}  // namespace meshalyzer
