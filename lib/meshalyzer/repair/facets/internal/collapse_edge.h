#pragma once

#include "meshalyzer/repair/facets/internal/mend_rules.h"
#include "meshalyzer/repair/facets/internal/mend_step.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"

#include <array>

namespace meshalyzer {

/// Merges the ends of an edge at the position of one of them: of a fixed one, else of the one where
/// the surface moves less. If neither will do, an edge below the tolerance may be merged at its
/// midpoint.
///
/// No face round the edge is turned over, and none becomes thin unless more thin faces are removed
/// than created; the topology is preserved. Fins at the edge go with it, i.e. vertices with three
/// faces that would become flat.
[[nodiscard]] MendAttempt collapse_edge(const WorkingMesh& mesh, const MendRules& rules,
                                        const std::array<Index, 2>& ends);

}  // namespace meshalyzer
