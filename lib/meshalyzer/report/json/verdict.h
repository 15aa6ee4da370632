#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/tree.h"
#include "meshalyzer/report/json/writer.h"

#include <optional>

namespace meshalyzer {

/// Writes the members "good" and "reasons": null and an empty list if there is no verdict.
void write_verdict_members(JsonWriter& json, const std::optional<Goodness>& verdict);

/// Writes the member "verdict", an object with these members.
void write_verdict(JsonWriter& json, const std::optional<Goodness>& verdict);

/// Reads what write_verdict_members() wrote.
[[nodiscard]] std::optional<Goodness> read_verdict_members(const JsonNode& object);

/// Defines "verdict".
void define_verdict(SchemaDefinitions& schema);

}  // namespace meshalyzer
