#pragma once

#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/mesh_report.h"
#include "meshalyzer/report/text/table.h"
#include "meshalyzer/set/set_analysis.h"

namespace meshalyzer {

/// Returns a table of the pairs of meshes that intersect, one row for each; it has only titles if
/// there are none or they were not requested.
[[nodiscard]] TextTable meetings_table(const SetAnalysis& set);

/// Appends the numbers of intersections and of meshes inside others; nothing if they were not
/// requested.
void append_meeting_counts(LineSink& lines, const SetAnalysis& set);

/// Appends the section INTERSECTIONS BETWEEN MESHES; nothing if these were not requested.
///
/// Meshes that intersect or are inside others are named; the pairs of faces only unless the style
/// is None.
void append_meetings(TextLines& lines, const SetAnalysis& set, OffenderStyle style);

}  // namespace meshalyzer
