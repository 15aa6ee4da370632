#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/html/writer.h"

namespace meshalyzer {

/// Appends the figures of a quantity and its histogram, drawn and in numbers, or the reason why
/// there is no value.
void append_figures(HtmlWriter& html, const Quantity& quantity, const Statistics& statistics);

/// Appends the section of the statistics of vertices, edges and faces.
void append_statistics_section(HtmlWriter& html, const ElementMeasures<Statistics>& measures);

/// Appends that section, and the one of curvatures if the analysis has them.
void append_statistics_sections(HtmlWriter& html, const Analysis& analysis);

}  // namespace meshalyzer
