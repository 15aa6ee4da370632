#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/report/text/lines.h"
#include "meshalyzer/report/text/statistics.h"

namespace meshalyzer {

/// Appends over what area curvatures are, how many vertices have none and why, the total angle
/// defect.
void append_curvature_counts(LineSink& lines, const CurvatureStatistics& curvature);

/// Calls `tell(QuantityName, Statistics)` for each of K, H, k1 and k2.
template <typename Tell>
void for_each_curvature(const CurvatureStatistics& curvature, Tell tell) {
  constexpr std::string_view kNone = "no vertex inside a surface that has one";
  tell(QuantityName{"Gaussian curvature", kNone}, curvature.gaussian);
  tell(QuantityName{"mean curvature", kNone}, curvature.mean);
  tell(QuantityName{"principal curvature k1", kNone}, curvature.k1);
  tell(QuantityName{"principal curvature k2", kNone}, curvature.k2);
}

/// Appends the curvatures in figures: over what area, how many vertices have none and why, the
/// total angle defect beside what Gauss and Bonnet say, the statistics of K, H, k1 and k2.
void append_curvature(TextLines& lines, const CurvatureStatistics& curvature);

}  // namespace meshalyzer
