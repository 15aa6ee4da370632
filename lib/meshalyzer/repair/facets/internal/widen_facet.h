#pragma once

#include "meshalyzer/repair/facets/internal/mend_rules.h"
#include "meshalyzer/repair/facets/internal/mend_step.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"

namespace meshalyzer {

/// Widens a thin face: one of its corners moves away from the line of the other two, by little more
/// than the tolerance, so that no altitude and no edge is below it any more.
///
/// This is the last resort, for a face that can neither be retracted nor lose an edge: it keeps all
/// faces and the topology. No face is turned over or becomes thin.
[[nodiscard]] MendAttempt widen_facet(const WorkingMesh& mesh, const MendRules& rules, Index face);

}  // namespace meshalyzer
