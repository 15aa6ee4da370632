#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/repair/weld/internal/weld_edges.h"

#include <span>
#include <string_view>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): which of the border edges at one place belong together.

/// One of the border edges at a place: its number, and how it runs against the first of them.
struct EdgeAtPlace {
  Index edge = 0;
  EdgeRun run = EdgeRun::Same;
};

/// Tells which edges to join, and why others are not.
struct Pairing {
  /// Their distances are for the caller to tell.
  std::vector<WeldJoin> joins;
  /// Empty where nothing is refused.
  std::string_view refusal;
};

/// Pairs the border edges at one place.
///
/// Two are joined, but for those of one direction whose faces lie on each other. More are joined as
/// pair_round_edge() pairs their faces, where those that begin a solid alternate with those that
/// end one; where they do not, none is joined. Only the lowest of faces with the same corners
/// and orientation counts, and such faces with opposite orientations are not joined.
///
/// @param at_place  At least two, ascending by edge; the first one's run is Same.
/// @param reach     How far apart ends at one place may be: pairs of more than two whose faces lie
///                  within that of each other are refused, for their order is left to chance. 0:
///                  they are at the very same place.
[[nodiscard]] Pairing pair_edges_at_place(const Soup& soup, std::span<const WeldEdge> edges,
                                          std::span<const EdgeAtPlace> at_place, double reach);

}  // namespace meshalyzer
