#pragma once

#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/tree.h"
#include "meshalyzer/report/json/writer.h"

#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// Writes a text that may be invalid UTF-8, such as a path, as a member `name`.
///
/// If it is, a further member `name_bytes` holds its bytes, each as the character of its number,
/// because `name` alone would not identify the path.
void write_bytes(JsonWriter& json, std::string_view name, std::string_view bytes);

/// Reads the text that write_bytes() wrote.
[[nodiscard]] std::string read_bytes(const JsonNode& object, std::string_view name);

/// Returns the schema of a path that write_bytes() wrote.
[[nodiscard]] std::vector<SchemaMember> path_members();

}  // namespace meshalyzer
