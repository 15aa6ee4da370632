#pragma once

#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/set/set_analysis.h"

namespace meshalyzer {

/// Appends what the meshes of a set have together.
void append_set_totals(LineSink& lines, const SetAnalysis& set);

}  // namespace meshalyzer
