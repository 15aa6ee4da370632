#pragma once

#include "meshalyzer/report/text.h"
#include "meshalyzer/report/text_lines.h"
#include "meshalyzer/set/set_analysis.h"

namespace meshalyzer {

/// Appends the section SEPARATION DISTANCES; nothing where these were not asked for. Where they
/// could not be measured it tells why.
/// @param style  Unless None the figures of each mesh stand there in full, with histograms.
void append_separation(TextLines& lines, const SetAnalysis& set, OffenderStyle style);

}  // namespace meshalyzer
