#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/html/writer.h"

namespace meshalyzer {

/// Appends the figures of a quantity and its histogram, drawn and in numbers. Where there is no
/// value it says why.
void append_figures(HtmlWriter& html, const Quantity& quantity, const Statistics& statistics);

/// Appends the section of all that is measured of vertices, edges and faces.
void append_statistics_section(HtmlWriter& html, const ElementMeasures<Statistics>& measures);

/// Appends that section, and the one of curvatures where the analysis has them.
void append_statistics_sections(HtmlWriter& html, const Analysis& analysis);

}  // namespace meshalyzer
