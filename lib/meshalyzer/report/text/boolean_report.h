#pragma once

#include "meshalyzer/report/boolean_report.h"

#include <string>

namespace meshalyzer {

/// Returns the report of a boolean operation for people: one `name: value` per line.
[[nodiscard]] std::string text_report(const BooleanReport& report);

}  // namespace meshalyzer
