#pragma once

#include "meshalyzer/report/repair_report.h"
#include "meshalyzer/report/text/defects_report.h"

#include <string>

namespace meshalyzer {

/// Returns the report of a repair for people: what came out, defects before and after by code, what
/// was done, pass by pass, and what remains, with reasons.
///
/// What was done is told by the ids of the input, but of the output for what was added; what
/// remains by those of the output.
///
/// @param lists  Full: also each operation by itself, and what was not asked for.
[[nodiscard]] std::string text_report(const RepairReport& report, ListLength lists);

}  // namespace meshalyzer
