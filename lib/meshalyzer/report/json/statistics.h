#pragma once

#include "meshalyzer/analysis/element_measures.h"
#include "meshalyzer/base/statistics.h"
#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/tree.h"
#include "meshalyzer/report/json/writer.h"

namespace meshalyzer {

/// Writes statistics as a value ("statistics" in doc/report.schema.json).
void write_statistics(JsonWriter& json, const Statistics& statistics);

/// Reads the statistics that write_statistics() wrote.
[[nodiscard]] Statistics read_statistics(const JsonNode& object);

/// Writes a summary, which has no histogram, in one line.
void write_summary(JsonWriter& json, const Summary& summary);
[[nodiscard]] Summary read_summary(const JsonNode& object);

/// Writes the statistics of vertices, edges and faces, one member for each quantity.
/// @param measures  The statistics, or null if they were not computed: then the members are null
///                  too.
void write_measures(JsonWriter& json, const ElementMeasures<Statistics>* measures);

/// Writes the summaries of these quantities, one line for each.
void write_measures(JsonWriter& json, const ElementMeasures<Summary>& measures);

/// Tells whether an object has the members of write_measures(), possibly null.
[[nodiscard]] bool has_measures(const JsonNode& object);

/// Tells whether write_measures() wrote nulls into an object.
[[nodiscard]] bool has_null_measures(const JsonNode& object);

/// Reads the statistics that write_measures() wrote into an object.
void read_measures(const JsonNode& object, ElementMeasures<Statistics>& measures);
void read_measures(const JsonNode& object, ElementMeasures<Summary>& measures);

/// Defines "statistics" and "summary", which write_statistics() and write_summary() write.
void define_statistics(SchemaDefinitions& schema);

/// Returns the statistics of a quantity as a member.
[[nodiscard]] SchemaMember statistics_member(const Quantity& quantity);

/// Appends the schema of the members that write_measures() writes.
/// @param type  "statistics" or "summary".
void append_measures(std::vector<SchemaMember>& members, std::string_view type,
                     SchemaMember::Presence presence);

}  // namespace meshalyzer
