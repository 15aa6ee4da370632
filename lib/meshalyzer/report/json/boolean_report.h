#pragma once

#include "meshalyzer/report/boolean_report.h"

#include <string>

namespace meshalyzer {

/// Returns the report of a boolean operation as JSON; see doc/booleans.md.
[[nodiscard]] std::string json_report(const BooleanReport& report);

}  // namespace meshalyzer
