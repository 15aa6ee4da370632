#pragma once

#include "meshalyzer/repair/fix_defects.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// The result of a repair for the mesh of one face of a body.
struct FaceTracking {
  /// The name of the face's group.
  std::string group;
  /// The faces of its mesh before the repair, by index in the input.
  std::vector<Index> before;
  /// The faces of its mesh after the repair, by index in the result.
  std::vector<Index> after;
};

struct FaceRepairResult {
  RepairResult repair;
  /// The faces of the body whose meshes were edited, in the order of their groups.
  std::vector<FaceTracking> edited;
};

/// Repairs the meshes that are attached to the faces of a body: those of the groups of a soup.
///
/// The common borders of groups keep every vertex and edge, so that the body stays as watertight as
/// it was. RepairOptions::groups counts as Groups::Faces, and disjoint is not fixed.
///
/// @throws InvalidArgument  as fix_defects().
[[nodiscard]] FaceRepairResult fix_face_defects(Soup soup, RepairOptions options = {});

}  // namespace meshalyzer
