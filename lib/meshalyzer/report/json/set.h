#pragma once

#include "meshalyzer/report/json/schema_writer.h"
#include "meshalyzer/report/json/writer.h"
#include "meshalyzer/set/set_analysis.h"

#include <functional>

namespace meshalyzer {

/// Writes the members of "set" (doc/report.schema.json) except "closest"; the caller has begun the
/// object.
/// @param on_row  Called after each row of a list, when the text so far may be drained.
void write_set_members(JsonWriter& json, const SetAnalysis& set,
                       const std::function<void()>& on_row);

/// Defines "set" and its parts.
void define_set(SchemaDefinitions& schema);

}  // namespace meshalyzer
