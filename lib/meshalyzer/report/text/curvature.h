#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/text/lines.h"

namespace meshalyzer {

/// Appends the kind of area, the numbers of vertices without curvature by reason, and the total
/// angle defect.
void append_curvature_counts(LineSink& lines, const CurvatureStatistics& curvature);

/// Appends the lines of append_curvature_counts(), then the statistics of the Gaussian, mean and
/// principal curvatures.
void append_curvature(TextLines& lines, const CurvatureStatistics& curvature);

}  // namespace meshalyzer
