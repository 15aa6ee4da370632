#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/tree.h"
#include "meshalyzer/report/json/writer.h"

#include <optional>

namespace meshalyzer {

/// Writes the curvatures of an analysis as members of the characteristics: "gaussian_curvature",
/// "mean_curvature", "k1", "k2" and "curvature", with the kind of area, the total angle defect, and
/// the numbers of vertices with a curvature, and without one by reason.
void write_curvature(JsonWriter& json, const CurvatureStatistics& curvature);

/// Reads the curvatures that write_curvature() wrote into an object, or nothing if it did not.
[[nodiscard]] std::optional<CurvatureStatistics> read_curvature(const JsonNode& object);

/// Defines "curvature", which describes the statistics.
void define_curvature(SchemaDefinitions& schema);

/// Appends the schema of the members that write_curvature() writes.
void append_curvature_members(std::vector<SchemaMember>& members);

}  // namespace meshalyzer
