#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/text/lines.h"

namespace meshalyzer {

/// Appends over what area curvatures are, how many vertices have none and why, the total angle
/// defect.
void append_curvature_counts(LineSink& lines, const CurvatureStatistics& curvature);

/// Appends the curvatures in figures: over what area, how many vertices have none and why, the
/// total angle defect beside what Gauss and Bonnet say, the statistics of K, H, k1 and k2.
void append_curvature(TextLines& lines, const CurvatureStatistics& curvature);

}  // namespace meshalyzer
