#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/tree.h"
#include "meshalyzer/report/json/writer.h"

namespace meshalyzer {

/// Writes the list of all components, with their statistics if the analysis has them.
void write_components(JsonWriter& json, const Analysis& analysis);

/// Reads the components that write_components() wrote into an analysis that is otherwise complete.
void read_components(const JsonNode& list, Analysis& analysis);

/// Defines "component".
void define_component(SchemaDefinitions& schema);

}  // namespace meshalyzer
