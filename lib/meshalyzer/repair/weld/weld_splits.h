#pragma once

#include "meshalyzer/repair/weld/weld_chains.h"
#include "meshalyzer/repair/weld/weld_operations.h"

#include <span>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): closing cracks with T-junctions.

/// Makes operations that split the face of a long edge at the vertices of the chain along it, and
/// so close the crack: the ends of the edge are joined with those of the chain, and the corners
/// that the face gets are the chain's own. Where groups are faces of a body, an edge between two of
/// them gets no vertex.
///
/// Chains with a busy vertex wait for the next time.
void add_split_operations(WeldState& state, std::span<const WeldChain> chains);

}  // namespace meshalyzer
