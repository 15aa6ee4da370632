#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/json/report.h"
#include "meshalyzer/report/json/writer.h"

namespace meshalyzer {

/// Writes the object of all offending elements (contract 4, "offenders") as a value, everything by
/// file id.
///
/// Lists of edges, pairs and measured faces have one element a line; lists of single ids are one
/// line. The lists of -b ... -f stand in it where they were asked for; with JsonOffenders::Omit
/// only those do.
void write_offenders(JsonWriter& json, const Analysis& analysis, JsonOffenders offenders);

/// Writes a break of the numbering as a value.
void write_numbering(JsonWriter& json, const NumberingBreak& place);

}  // namespace meshalyzer
