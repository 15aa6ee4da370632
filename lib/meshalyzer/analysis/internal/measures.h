#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/analysis/internal/describe_components.h"
#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/topology/components.h"

namespace meshalyzer {

/// Measures faces, edges and vertices: the statistics of the mesh and of each component, the area,
/// and the elements beyond the thresholds of AnalysisOptions; zero-area faces and
/// indistinguishable vertices and edges too.
///
/// These parts of `analysis` are filled in.
///
/// @return     The sums over the faces of each component.
/// @complexity O(#V + #F), plus O(#V log #V) for the search for indistinguishable vertices.
[[nodiscard]] ComponentMeasures measure(const CutMesh& cut, const Components& components,
                                        const AnalysisOptions& options, Analysis& analysis);

}  // namespace meshalyzer
