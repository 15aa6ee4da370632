#pragma once

#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/mesh_report.h"
#include "meshalyzer/report/text/table.h"
#include "meshalyzer/set/set_analysis.h"

namespace meshalyzer {

/// Appends the options that limited the search, if any.
void append_separation_options(LineSink& lines, const SetSeparation& separation);

/// Appends the numbers of vertices inside another mesh, and of those without a closest point.
void append_separation_counts(LineSink& lines, const SetSeparation& separation);

/// Returns a table of the figures of each mesh, one row for each.
/// @param set  A set with separation distances.
[[nodiscard]] TextTable separation_table(const SetAnalysis& set);

/// Appends the section SEPARATION DISTANCES, with the reason if they could not be measured; nothing
/// if they were not requested.
/// @param style  Unless it is None, the figures of each mesh are complete, with histograms.
void append_separation(TextLines& lines, const SetAnalysis& set, OffenderStyle style);

}  // namespace meshalyzer
