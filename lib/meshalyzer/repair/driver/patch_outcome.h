#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace meshalyzer {

/// The outcome of a repair for a patch of intersecting faces: a defect self-intersection.
struct PatchOutcome {
  /// The index of the patch among the defects of RepairResult::before.
  std::size_t defect = 0;
  /// The names of the passes that changed its faces, or faces made of them, in the order in which
  /// they first did: "cut intersections", ...
  std::vector<std::string> passes;
  /// An upper bound of the distance by which the surface has moved there. Walls that were proved to
  /// lie inside, and hole patches, do not count.
  double distance = 0.0;
  /// Tells whether no face that was made of its faces intersects another any more.
  bool is_mended = false;
  /// The reason why it is not repaired; empty if it is.
  std::string reason;
};

}  // namespace meshalyzer
