#pragma once

#include <string>

namespace meshalyzer {

/// Returns the JSON Schema of JsonReport: doc/report.schema.json. Its keys and their meanings are
/// those of the tables that the report is written from.
[[nodiscard]] std::string json_schema();

}  // namespace meshalyzer
