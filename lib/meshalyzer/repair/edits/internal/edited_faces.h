#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/edits/internal/skipped_operations.h"

#include <vector>

namespace meshalyzer {

/// The faces of a soup after edits, in their new order, their corners still numbered as in Edits.
struct EditedFaces {
  /// For each face: the old face that it is, or #old faces + the number of the added one.
  std::vector<Index> sources;
  std::vector<Triangle> triangles;
  std::vector<Group> groups;
  /// #old faces: the new index of each; kNoIndex for removed ones.
  std::vector<Index> new_index;
};

/// @complexity O(#F + edits).
[[nodiscard]] EditedFaces edit_faces(const Soup& soup, const Edits& edits,
                                     const SkippedOperations& skipped);

}  // namespace meshalyzer
