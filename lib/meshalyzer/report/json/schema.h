#pragma once

#include <string>
#include <string_view>

namespace meshalyzer {

/// The value of "schema" in the reports of JsonReport.
inline constexpr std::string_view kReportSchema = "meshalyzer-report/1";

/// Returns the JSON Schema of JsonReport: doc/report.schema.json. Keys and descriptions come from
/// the same tables as those of the report.
[[nodiscard]] std::string json_schema();

}  // namespace meshalyzer
