#pragma once

#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/mesh_report.h"
#include "meshalyzer/report/text/table.h"
#include "meshalyzer/set/set_analysis.h"

namespace meshalyzer {

/// Appends what was looked at, where that was limited.
void append_separation_options(LineSink& lines, const SetSeparation& separation);

/// Appends how many vertices are inside another mesh, and how many have no closest point.
void append_separation_counts(LineSink& lines, const SetSeparation& separation);

/// Returns the figures of each mesh, a row each.
/// @param set  With separation distances.
[[nodiscard]] TextTable separation_table(const SetAnalysis& set);

/// Appends the section SEPARATION DISTANCES; nothing where these were not asked for. Where they
/// could not be measured it tells why.
/// @param style  Unless None the figures of each mesh stand there in full, with histograms.
void append_separation(TextLines& lines, const SetAnalysis& set, OffenderStyle style);

}  // namespace meshalyzer
