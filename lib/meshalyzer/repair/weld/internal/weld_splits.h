#pragma once

#include "meshalyzer/repair/weld/internal/weld_cracks.h"
#include "meshalyzer/repair/weld/internal/weld_operations.h"

#include <span>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): closing cracks with T-junctions.

/// Makes operations that split faces at a crack at the vertices of the other side, and so close it:
/// the ends of both sides are joined, and the corners that a face gets are the other side's own.
/// Where groups are faces of a body, an edge between two of them gets no vertex.
///
/// Cracks with a busy vertex wait for the next time.
void add_split_operations(WeldState& state, std::span<const WeldCrack> cracks);

}  // namespace meshalyzer
