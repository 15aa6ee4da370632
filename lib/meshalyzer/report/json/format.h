#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/tree.h"

#include <string_view>
#include <vector>

namespace meshalyzer {

/// Writes "format", the format that a file was read as, and "named_format", where its name says
/// another one.
void write_format(JsonWriter& json, std::string_view path, Format format);

/// How schemas describe them.
[[nodiscard]] std::vector<SchemaMember> format_members();

/// Reads the name of a format.
[[nodiscard]] Format read_format(const JsonNode& node);

}  // namespace meshalyzer
