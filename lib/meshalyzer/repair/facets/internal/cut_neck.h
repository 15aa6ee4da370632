#pragma once

#include "meshalyzer/repair/facets/internal/mend_rules.h"
#include "meshalyzer/repair/facets/internal/mend_step.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"

#include <array>

namespace meshalyzer {

/// Cuts a neck that is thinner than the tolerance: three edges, each shorter, form a ring round it
/// that is no face. The surface is cut along the ring, and on each side the three vertices are
/// merged in one of them, in another on either side, so that the sides do not touch.
///
/// This is for an edge that cannot be collapsed because its ends have a neighbour in common beyond
/// the edge. No face is turned over, and none becomes thin unless more thin faces go; the topology
/// changes by no more than that: two parts, or two places of one, are no longer joined.
[[nodiscard]] MendAttempt cut_neck(const WorkingMesh& mesh, const MendRules& rules,
                                   const std::array<Index, 2>& edge);

}  // namespace meshalyzer
