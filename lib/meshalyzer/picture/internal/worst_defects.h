#pragma once

#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/topology/components.h"

#include <vector>

namespace meshalyzer {

// The values of the field `defect` are 0 for none, else 1 + the position of a code in DefectCode.

/// Finds for each face the worst defect that lists it, one of its vertices or one of its edges.
///
/// @param report  The defects of this soup.
/// @return        #F: the value of each face.
/// @complexity    O(#V + #F) and O(n log n) for the n edges that defects list.
[[nodiscard]] std::vector<double> worst_defects(const Soup& soup, const DefectReport& report);

/// Tells whether a defect is a whole component, of which it lists the first face only.
[[nodiscard]] bool names_component(const Defect& defect);

/// Gives each face of a component that is a defect the value of that defect if that is worse.
///
/// @param values      The result of worst_defects().
/// @param components  The components of the mesh.
/// @complexity        O(#F).
[[nodiscard]] std::vector<double> spread_over_components(std::vector<double> values,
                                                         const DefectReport& report,
                                                         const CutMesh& cut,
                                                         const Components& components);

/// Returns the worse of two values: errors are worse than warnings, then the first code is worst,
/// and no defect is best.
[[nodiscard]] double worse_defect(double a, double b);

}  // namespace meshalyzer
