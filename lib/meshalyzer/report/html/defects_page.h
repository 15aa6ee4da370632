#pragma once

#include "meshalyzer/defects/defect.h"
#include "meshalyzer/report/html/page_mesh.h"

#include <string>

namespace meshalyzer {

/// Returns the page that shows the defects of a mesh.
/// @param requested  The codes that count in the verdict.
[[nodiscard]] std::string html_report(const PageMesh& mesh, const DefectCodes& requested);

}  // namespace meshalyzer
