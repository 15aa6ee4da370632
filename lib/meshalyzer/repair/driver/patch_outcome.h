#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace meshalyzer {

/// What a repair has made of a patch of intersecting faces: a defect self-intersection.
struct PatchOutcome {
  /// The place of the patch among the defects of RepairResult::before.
  std::size_t defect = 0;
  /// The passes that changed its faces, or what was made of them, in the order in which they first
  /// did: "cut intersections", ...
  std::vector<std::string> passes;
  /// An upper bound of how far the surface has moved there. Walls that were proved to lie inside,
  /// and hole patches, do not count.
  double distance = 0.0;
  /// Whether nothing that was made of its faces intersects any more.
  bool is_mended = false;
  /// Why it is not mended; empty where it is.
  std::string reason;
};

}  // namespace meshalyzer
