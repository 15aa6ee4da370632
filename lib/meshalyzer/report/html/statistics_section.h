#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/html/writer.h"
#include "meshalyzer/report/text/statistics.h"
#include "meshalyzer/set/set_analysis.h"

namespace meshalyzer {

/// Appends the figures of a quantity and its histogram, drawn and in numbers. Where there is no
/// value it says why.
void append_figures(HtmlWriter& html, const QuantityName& quantity, const Statistics& statistics);

/// Appends the section of all that is measured of faces, edges and vertices, curvatures too where
/// the analysis has them.
void append_statistics_section(HtmlWriter& html, const Analysis& analysis);

/// The same for all meshes of a set as one.
void append_statistics_section(HtmlWriter& html, const SetStatistics& statistics);

}  // namespace meshalyzer
