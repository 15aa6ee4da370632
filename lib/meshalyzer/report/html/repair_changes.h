#pragma once

#include "meshalyzer/picture/scene.h"
#include "meshalyzer/report/html/page.h"
#include "meshalyzer/report/repair_report.h"

#include <vector>

namespace meshalyzer {

/// What a repair changed, on one of its meshes: for each change what the page says of it, and where
/// it is.
struct ShownChanges {
  std::vector<PageChange> changes;
  std::vector<ChangedPlace> places;
};

struct RepairChanges {
  /// On the input: the faces that each operation dropped, cut or changed.
  ShownChanges before;
  /// On all meshes of the result as one: the faces that each operation made or changed, as far as
  /// they are there in the end, and the seams: the edges along which faces meet that lay apart.
  ShownChanges after;
};

/// Lists the operations of a repair, in their order, at most kListedOfACode of a pass and mesh.
///
/// @param report  What is asked for is what was written, or would be.
/// @param final_soup  The meshes of the report, as the files hold them, one after the other.
/// @complexity    O(#F of all meshes + size of the log).
[[nodiscard]] RepairChanges find_changes(const RepairReport& report, const Soup& input,
                                         const Soup& final_soup);

}  // namespace meshalyzer
