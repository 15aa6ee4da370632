#pragma once

#include "meshalyzer/repair/facets/internal/mend_rules.h"
#include "meshalyzer/repair/facets/internal/mend_step.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"
#include "meshalyzer/repair/facets/turning_over.h"

namespace meshalyzer {

/// Widens a thin face: one of its corners moves away from the line of the other two, by little more
/// than the tolerance, so that no altitude and no edge is below it any more.
///
/// This is the last resort, for a face that can neither be retracted nor lose an edge: it keeps all
/// faces and the topology. No face becomes thin.
///
/// @param turning  Tells whether the face and those round the corner may come to face the other
///                 side. Where layers are little farther apart than the tolerance, their faces
///                 must.
[[nodiscard]] MendAttempt widen_facet(const WorkingMesh& mesh, const MendRules& rules, Index face,
                                      TurningOver turning);

}  // namespace meshalyzer
