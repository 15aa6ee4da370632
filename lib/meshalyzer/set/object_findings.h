#pragma once

#include "meshalyzer/set/separation.h"
#include "meshalyzer/set/set_analysis.h"

#include <optional>
#include <vector>

namespace meshalyzer {

/// What was found between one mesh of a set, the owner, and the others. Each pair of meshes has one
/// owner: the one that comes first in the order in space.
struct ObjectFindings {
  /// Its number in the set.
  Index owner = 0;
  /// Where asked for: with all meshes that come later in the order in space.
  std::optional<SetIntersections> intersections;
  /// Where asked for: from the owner's vertices to all others.
  std::optional<ObjectSeparation> separation;
};

}  // namespace meshalyzer
