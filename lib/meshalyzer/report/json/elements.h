#pragma once

#include "meshalyzer/analysis/offenders.h"
#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/tree.h"
#include "meshalyzer/report/json/writer.h"

namespace meshalyzer {

// The elements of a mesh in JSON, by their ids in the file.

/// Returns an id in the place of a record, see index_records().
/// @throws InvalidArgument if no file can have the id.
[[nodiscard]] Index read_id(const JsonNode& node);

/// Reads the kind that contact_name() names.
[[nodiscard]] ContactKind read_contact(const JsonNode& node);

/// Writes a break of the numbering as a value.
void write_numbering(JsonWriter& json, const NumberingBreak& place);

/// Reads the break that write_numbering() wrote.
[[nodiscard]] NumberingBreak read_numbering(const JsonNode& object);

/// Defines "ids", "contact" and "numbering".
void define_elements(SchemaDefinitions& schema);

}  // namespace meshalyzer
