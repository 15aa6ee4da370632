#pragma once

#include "meshalyzer/report/html/writer.h"
#include "meshalyzer/set/set_analysis.h"

namespace meshalyzer {

/// Appends what is known of a set as a whole: totals, how its meshes intersect and how far they are
/// apart, statistics.
void append_set_sections(HtmlWriter& html, const SetAnalysis& set);

}  // namespace meshalyzer
