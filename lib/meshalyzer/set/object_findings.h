#pragma once

#include "meshalyzer/set/separation.h"
#include "meshalyzer/set/set_analysis.h"

#include <optional>
#include <vector>

namespace meshalyzer {

/// The findings between one mesh of a set, the owner, and the others. Each pair of meshes has one
/// owner: the one that comes first in the order in space.
struct ObjectFindings {
  /// Its number in the set.
  Index owner = 0;
  /// The intersections with all meshes that come later in the order in space; present where asked
  /// for.
  std::optional<SetIntersections> intersections;
  /// The separation of the owner's vertices from all others; present where asked for.
  std::optional<ObjectSeparation> separation;
};

}  // namespace meshalyzer
