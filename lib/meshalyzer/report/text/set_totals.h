#pragma once

#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/set/set_analysis.h"

namespace meshalyzer {

/// Appends the totals of the meshes of a set.
void append_set_totals(LineSink& lines, const SetAnalysis& set);

}  // namespace meshalyzer
