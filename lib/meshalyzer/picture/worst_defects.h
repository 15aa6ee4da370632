#pragma once

#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/topology/components.h"

#include <vector>

namespace meshalyzer {

// Private to the picture module: the values of the field `defect`: 0 for none, else 1 + the place
// of a code in DefectCode.

/// The worst listed defect that each face, one of its vertices or one of its edges is in.
///
/// @param report  Of this soup.
/// @return        #F.
/// @complexity    O(#V + #F) and O(n log n) for the n edges that defects list.
[[nodiscard]] std::vector<double> worst_defects(const Soup& soup, const DefectReport& report);

/// Whether a defect is of a whole component, which it names by its first face.
[[nodiscard]] bool names_component(const Defect& defect);

/// The same with the defects of whole components at each of their faces.
///
/// @param values      As worst_defects() gives them.
/// @param components  Of the mesh.
/// @complexity        O(#F).
[[nodiscard]] std::vector<double> spread_over_components(std::vector<double> values,
                                                         const DefectReport& report,
                                                         const CutMesh& cut,
                                                         const Components& components);

/// The worse of two values: errors before warnings, then the first code, and none is best.
[[nodiscard]] double worse_defect(double a, double b);

}  // namespace meshalyzer
