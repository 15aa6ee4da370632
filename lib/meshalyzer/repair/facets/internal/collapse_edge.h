#pragma once

#include "meshalyzer/repair/facets/internal/mend_rules.h"
#include "meshalyzer/repair/facets/internal/mend_step.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"

#include <array>

namespace meshalyzer {

/// Merges the ends of an edge at the place of one of them: of a fixed one, else of the one where
/// the surface moves less. An edge below the tolerance may be merged in its middle where neither
/// end will do.
///
/// No face round it is turned over, and none becomes thin, but where more thin faces go than come;
/// the topology stays.
[[nodiscard]] MendAttempt collapse_edge(const WorkingMesh& mesh, const MendRules& rules,
                                        const std::array<Index, 2>& ends);

}  // namespace meshalyzer
