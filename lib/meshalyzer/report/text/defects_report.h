#pragma once

#include "meshalyzer/report/repair_report.h"
#include "meshalyzer/report/text/list_length.h"

#include <string>

namespace meshalyzer {

/// Returns the report of the defects of a mesh for people: its size, the tolerances, the count of
/// each code, the passes that fix what was found, a line for each defect, and the outcome of a
/// repair for the self-intersections.
[[nodiscard]] std::string text_report(const FoundDefects& found, ListLength lists);

}  // namespace meshalyzer
