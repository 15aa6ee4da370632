#pragma once

#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/tree.h"
#include "meshalyzer/report/json/writer.h"

#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// Writes a text that may be no UTF-8, such as a path, as a member `name`.
///
/// Where it is none a further member `name_bytes` holds its bytes, each as the character of its
/// number: `name` alone would not tell one such path from another.
void write_bytes(JsonWriter& json, std::string_view name, std::string_view bytes);

/// Reads what write_bytes() wrote.
[[nodiscard]] std::string read_bytes(const JsonNode& object, std::string_view name);

/// How schemas describe a path that write_bytes() wrote.
[[nodiscard]] std::vector<SchemaMember> path_members();

}  // namespace meshalyzer
