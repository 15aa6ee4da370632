#pragma once

#include <string>

namespace meshalyzer {

/// Returns the JSON Schema of JsonReport: doc/report.schema.json. Keys and descriptions come from
/// the same tables as those of the report.
[[nodiscard]] std::string json_schema();

}  // namespace meshalyzer
