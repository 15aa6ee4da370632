#pragma once

#include "meshalyzer/report/text/mesh_report.h"
#include "meshalyzer/set/set_analysis.h"

#include <string>

namespace meshalyzer {

/// Returns the report of a set for people, in the manner of that of a mesh: its totals, then how
/// its meshes intersect and how far they are apart, where that was asked for.
///
/// @param offenders  Unless None each intersecting pair of faces of different meshes is named;
///                   CustomPoints is the same as Ids.
[[nodiscard]] std::string text_report(const SetAnalysis& set, OffenderStyle offenders);

/// Returns only that part of the report which tells what lies between the meshes; it is empty where
/// nothing of it was asked for.
[[nodiscard]] std::string text_report_between(const SetAnalysis& set, OffenderStyle offenders);

}  // namespace meshalyzer
