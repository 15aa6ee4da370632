#pragma once

#include "meshalyzer/report/repair_report.h"
#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/list_length.h"

namespace meshalyzer {

/// Appends a line for each patch, which is named by its first face: the passes that treat it and
/// how far the surface moves, or why it is left unchanged. Short lists have the first few, and a
/// line with the number of the others.
void append_patches(TextLines& lines, const PatchReport& report, ListLength lists);

}  // namespace meshalyzer
