#pragma once

#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/mesh_report.h"
#include "meshalyzer/report/text/table.h"
#include "meshalyzer/set/set_analysis.h"

namespace meshalyzer {

/// Returns the pairs of meshes that intersect, a row each; only the titles where there are none,
/// and for a set that was not asked about it.
[[nodiscard]] TextTable meetings_table(const SetAnalysis& set);

/// Appends how many there are, and which meshes are inside others; nothing where that was not asked
/// for.
void append_meeting_counts(LineSink& lines, const SetAnalysis& set);

/// Appends the section INTERSECTIONS BETWEEN MESHES; nothing where these were not asked for.
///
/// Which meshes intersect and which are inside others is told by name; the pairs of faces only
/// unless the style is None.
void append_meetings(TextLines& lines, const SetAnalysis& set, OffenderStyle style);

}  // namespace meshalyzer
