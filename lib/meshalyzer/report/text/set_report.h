#pragma once

#include "meshalyzer/report/text/mesh_report.h"
#include "meshalyzer/set/set_analysis.h"

#include <string>

namespace meshalyzer {

/// Returns the report of a set for people, in the style of that of a mesh: its totals, then the
/// intersections and the separation, if requested.
///
/// @param offenders  Unless it is None, each intersecting pair of faces of different meshes is
///                   named; CustomPoints is the same as Ids.
[[nodiscard]] std::string text_report(const SetAnalysis& set, OffenderStyle offenders);

/// Returns only the part of the report about the relations between the meshes, after the verdict on
/// the set if the meshes were judged; it is empty if no relations were requested.
[[nodiscard]] std::string text_report_between(const SetAnalysis& set, OffenderStyle offenders);

}  // namespace meshalyzer
