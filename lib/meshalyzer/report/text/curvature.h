#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/text/lines.h"

namespace meshalyzer {

/// Appends the kind of area, the numbers of vertices without curvature by reason, and the total
/// angle defect.
void append_curvature_counts(LineSink& lines, const CurvatureStatistics& curvature);

/// Appends the curvatures: the kind of area, the numbers of vertices without one by reason, the
/// total angle defect and its value by Gauss-Bonnet, and the statistics of K, H, k1 and k2.
void append_curvature(TextLines& lines, const CurvatureStatistics& curvature);

}  // namespace meshalyzer
