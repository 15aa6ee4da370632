#pragma once

#include "meshalyzer/report/text.h"
#include "meshalyzer/report/text_lines.h"
#include "meshalyzer/set/set_analysis.h"

namespace meshalyzer {

/// Appends the section INTERSECTIONS BETWEEN MESHES; nothing where these were not asked for.
///
/// Which meshes intersect and which are inside others is told by name; the pairs of faces only
/// unless the style is None.
void append_meetings(TextLines& lines, const SetAnalysis& set, OffenderStyle style);

}  // namespace meshalyzer
