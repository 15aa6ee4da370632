#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/tree.h"
#include "meshalyzer/report/json/writer.h"

#include <optional>

namespace meshalyzer {

/// Writes the curvatures of an analysis as members of the characteristics: "gaussian_curvature",
/// "mean_curvature", "k1", "k2" and "curvature", which tells over what area they are, the total
/// angle defect, and how many vertices have a curvature, or none and why.
void write_curvature(JsonWriter& json, const CurvatureStatistics& curvature);

/// Reads what write_curvature() wrote into an object; nothing where it did not.
[[nodiscard]] std::optional<CurvatureStatistics> read_curvature(const JsonNode& object);

/// Defines "curvature", which tells what the statistics are of.
void define_curvature(SchemaDefinitions& schema);

/// Appends what the schema says of what write_curvature() writes.
void append_curvature_members(std::vector<SchemaMember>& members);

}  // namespace meshalyzer
