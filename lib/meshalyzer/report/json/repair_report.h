#pragma once

#include "meshalyzer/report/repair_report.h"

#include <string>

namespace meshalyzer {

/// Returns the report of what is wrong with a mesh as JSON: see doc/repair.schema.json.
///
/// @param asked  The codes that count in `remaining`.
[[nodiscard]] std::string json_report(const MeshName& mesh, const DefectReport& report,
                                      const DefectCodes& asked);

/// Returns the report of a repair as JSON: what was wrong, what was done, what remains; see
/// doc/repair.schema.json. Faces that the tracking does not name are the input's face of the same
/// id, unchanged.
[[nodiscard]] std::string json_report(const RepairReport& report);

}  // namespace meshalyzer
