#pragma once

#include "meshalyzer/repair/weld/internal/weld_candidates.h"
#include "meshalyzer/repair/weld/internal/weld_operations.h"

#include <span>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): the choice among edges that are near each other.

/// Chooses joins among candidates, each edge once at most, and refuses if the choice is ambiguous.
///
/// Edges that are near each other and no others are paired as pair_edges_at_place() does; if the
/// reach is so long that one edge is near many, edges are paired that are much nearer to each other
/// than to any others. The rest is zipped: pairs that run against each other come before the
/// others, of those the ones with most ends joined already, as at the tips of a slit, and of those
/// always the pair whose ends are nearest.
[[nodiscard]] std::vector<WeldJoin> match_candidates(WeldState& state,
                                                     const WeldCandidates& candidates);

}  // namespace meshalyzer
