#pragma once

#include "meshalyzer/report/html/page_mesh.h"
#include "meshalyzer/report/repair_report.h"

#include <string>

namespace meshalyzer {

/// The input of the page of a repair. It only refers to its data.
struct RepairPage {
  const RepairReport& report;
  PageMesh before;
  /// All meshes of the result as one; its defects are those that remain.
  PageMesh after;
};

/// Returns the report of a repair as one HTML page: the defects before, the changes, the remaining
/// defects, and the mesh before and after.
[[nodiscard]] std::string html_report(const RepairPage& page);

}  // namespace meshalyzer
