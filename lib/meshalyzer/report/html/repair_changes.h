#pragma once

#include "meshalyzer/picture/scene.h"
#include "meshalyzer/report/html/page_mesh.h"
#include "meshalyzer/report/repair_report.h"

#include <vector>

namespace meshalyzer {

/// The changes of a repair on one mesh: the text and the place of each.
struct ShownChanges {
  std::vector<PageChange> changes;
  std::vector<ChangedPlace> places;
};

struct RepairChanges {
  /// The changes on the input: the faces that each operation dropped, cut or changed.
  ShownChanges before;
  /// The changes on all meshes of the result as one: the faces that each operation made or changed,
  /// if they still exist in the end, and the seams, edges along which faces meet that were apart.
  ShownChanges after;
};

/// Lists the operations of a repair in their order, at most kListedOfACode for each pass and mesh.
///
/// @param report  The report, with the meshes that were written, or would be.
/// @param final_soup  The meshes of the report, as the files hold them, one after the other.
/// @complexity    O(#F of all meshes + size of the log).
[[nodiscard]] RepairChanges find_changes(const RepairReport& report, const Soup& input,
                                         const Soup& final_soup);

}  // namespace meshalyzer
