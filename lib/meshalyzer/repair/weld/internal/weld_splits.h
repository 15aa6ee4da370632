#pragma once

#include "meshalyzer/repair/weld/internal/weld_cracks.h"
#include "meshalyzer/repair/weld/internal/weld_operations.h"

#include <span>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): closing cracks with T-junctions.

/// Makes operations that close a crack by splitting the faces along it at the vertices of the other
/// side: the ends of both sides are joined, and faces get vertices of the other side as corners. If
/// groups are faces of a body, an edge between two of them gets no vertex.
///
/// Cracks with a busy vertex wait for the next run.
void add_split_operations(WeldState& state, std::span<const WeldCrack> cracks);

}  // namespace meshalyzer
