#pragma once

#include "meshalyzer/analysis/element_measures.h"
#include "meshalyzer/base/statistics.h"
#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/tree.h"
#include "meshalyzer/report/json/writer.h"

namespace meshalyzer {

/// Writes statistics as a value ("statistics" in doc/report.schema.json).
void write_statistics(JsonWriter& json, const Statistics& statistics);

/// Reads what write_statistics() wrote.
[[nodiscard]] Statistics read_statistics(const JsonNode& object);

/// The same without a histogram, in one line.
void write_summary(JsonWriter& json, const Summary& summary);
[[nodiscard]] Summary read_summary(const JsonNode& object);

/// Writes the statistics of all that is measured of vertices, edges and faces, a member each.
/// @param measures  Null where they were not computed: then the members are null too.
void write_measures(JsonWriter& json, const ElementMeasures<Statistics>* measures);

/// Writes the summaries of the same, a line each.
void write_measures(JsonWriter& json, const ElementMeasures<Summary>& measures);

/// Tells whether an object has what write_measures() writes, as nulls too.
[[nodiscard]] bool has_measures(const JsonNode& object);

/// Tells whether write_measures() wrote nulls into an object.
[[nodiscard]] bool has_null_measures(const JsonNode& object);

/// Reads what write_measures() wrote into an object.
void read_measures(const JsonNode& object, ElementMeasures<Statistics>& measures);
void read_measures(const JsonNode& object, ElementMeasures<Summary>& measures);

/// Defines "statistics" and "summary", which write_statistics() and write_summary() write.
void define_statistics(SchemaDefinitions& schema);

/// Returns the statistics of a quantity as a member.
[[nodiscard]] SchemaMember statistics_member(const Quantity& quantity);

/// Appends what the schema says of what write_measures() writes.
/// @param type  "statistics" or "summary".
void append_measures(std::vector<SchemaMember>& members, std::string_view type,
                     SchemaMember::Presence presence);

}  // namespace meshalyzer
