#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/tree.h"

#include <string_view>
#include <vector>

namespace meshalyzer {

/// Writes "format", the format as which a file was read, and "named_format" if its name indicates
/// another one.
void write_format(JsonWriter& json, std::string_view path, Format format);

/// Returns the schemas of these members.
[[nodiscard]] std::vector<SchemaMember> format_members();

/// Reads the name of a format.
[[nodiscard]] Format read_format(const JsonNode& node);

}  // namespace meshalyzer
