#pragma once

#include "meshalyzer/report/repair_report.h"

#include <string>

namespace meshalyzer {

/// Returns the report of the defects of a mesh as JSON: see doc/repair.schema.json.
[[nodiscard]] std::string json_report(const FoundDefects& found);

/// Returns the report of a repair as JSON: the defects before, the changes, the remaining defects;
/// see doc/repair.schema.json. Faces that the tracking does not name are the unchanged input faces
/// of the same id.
[[nodiscard]] std::string json_report(const RepairReport& report);

}  // namespace meshalyzer
