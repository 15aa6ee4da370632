#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/topology/components.h"

namespace meshalyzer {

/// Measures faces, edges and vertices: the statistics of the mesh and of each component, the area,
/// and the elements beyond the thresholds of AnalysisOptions; zero-area faces and
/// indistinguishable vertices and edges too.
///
/// Fills in those parts of `analysis`, whose components must be there.
///
/// @complexity O(#V + #F), but for the search for indistinguishable vertices, O(#V log #V).
void measure(const CutMesh& cut, const Components& components, const AnalysisOptions& options,
             Analysis& analysis);

}  // namespace meshalyzer
