#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/json/report.h"
#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/tree.h"
#include "meshalyzer/report/json/writer.h"

namespace meshalyzer {

/// Writes the object of all offending elements ("offenders" in doc/report.schema.json) as a value,
/// everything by file id.
///
/// Lists of edges, pairs and measured faces have one line for each element; lists of single ids are
/// one line. Lists requested by a threshold are always written; with JsonOffenders::Omit only those
/// are.
void write_offenders(JsonWriter& json, const Analysis& analysis, JsonOffenders offenders);

/// Reads the lists that write_offenders() wrote; omitted ones stay empty. The result has ids in the
/// place of records, see index_records().
[[nodiscard]] Offenders read_offenders(const JsonNode& object);

/// Defines "offenders", and the elements of its lists.
void define_offenders(SchemaDefinitions& schema);

}  // namespace meshalyzer
