#pragma once

#include "meshalyzer/repair/weld/internal/weld_candidates.h"
#include "meshalyzer/repair/weld/internal/weld_operations.h"

#include <span>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): which of the edges that are near each other belong together.

/// Chooses joins among candidates, each edge once at most; refuses where it cannot tell.
///
/// Edges that are near each other and no others are paired as pair_edges_at_place() does; where the
/// reach is so long that one edge is near many, those that are much nearer each other than any
/// others. The rest is zipped: pairs that run against each other before the others, of those the
/// ones with most ends joined already, as at the tips of a slit, of those always the pair whose
/// ends are nearest.
[[nodiscard]] std::vector<WeldJoin> match_candidates(WeldState& state,
                                                     const WeldCandidates& candidates);

}  // namespace meshalyzer
