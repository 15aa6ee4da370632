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
/// Lists of edges, pairs and measured faces have one element a line; lists of single ids are one
/// line. Lists that were asked for by a threshold are always written; with JsonOffenders::Omit only
/// those are.
void write_offenders(JsonWriter& json, const Analysis& analysis, JsonOffenders offenders);

/// Reads what write_offenders() wrote; lists that it left out stay empty. In the place of each
/// record stands its id, see index_records().
[[nodiscard]] Offenders read_offenders(const JsonNode& object);

/// Defines "offenders", and what its lists are of.
void define_offenders(SchemaDefinitions& schema);

}  // namespace meshalyzer
