#pragma once

#include "meshalyzer/report/repair_report.h"

#include <string>

namespace meshalyzer {

/// Returns the report of what is wrong with a mesh as JSON: see doc/repair.schema.json.
[[nodiscard]] std::string json_report(const FoundDefects& found);

/// Returns the report of a repair as JSON: what was wrong, what was done, what remains; see
/// doc/repair.schema.json. Faces that the tracking does not name are the input's face of the same
/// id, unchanged.
[[nodiscard]] std::string json_report(const RepairReport& report);

}  // namespace meshalyzer
