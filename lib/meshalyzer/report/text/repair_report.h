#pragma once

#include "meshalyzer/report/repair_report.h"
#include "meshalyzer/report/text/list_length.h"

#include <string>

namespace meshalyzer {

/// Returns the report of a repair for people: the outcome, the defects before and after by code,
/// the changes, pass by pass, and the remaining defects with reasons.
///
/// Changes are described with the ids of the input, or of the output for added elements; remaining
/// defects with those of the output.
///
/// @param lists  The length of lists; Full also lists each operation, and defects that were not
///               requested.
[[nodiscard]] std::string text_report(const RepairReport& report, ListLength lists);

}  // namespace meshalyzer
