#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/repair/weld/internal/weld_edges.h"

#include <span>
#include <string_view>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): the pairing of the border edges at one position.

/// One of the border edges at a position: its number, and its direction relative to the first.
struct EdgeAtPlace {
  Index edge = 0;
  EdgeRun run = EdgeRun::Same;
};

/// The pairs to join, and the reasons why others are not joined.
struct Pairing {
  /// The pairs; the caller sets their distances.
  std::vector<WeldJoin> joins;
  /// The refusals; empty if nothing is refused.
  std::string_view refusal;
};

/// Pairs the border edges at one position.
///
/// Two edges are joined, unless they have one direction and their faces coincide. More are joined
/// as pair_round_edge() pairs their faces if those that begin a solid alternate with those that end
/// one; if they do not, none is joined. Only the lowest of faces with the same corners and
/// orientation counts, and such faces with opposite orientations are not joined.
///
/// @param at_place  At least two, ascending by edge; the first has run Same.
/// @param reach     The maximum distance between ends. Pairs of more than two whose faces lie
/// within it of each other are refused, because their order is left to chance. 0 if the ends
/// coincide.
[[nodiscard]] Pairing pair_edges_at_place(const Soup& soup, std::span<const WeldEdge> edges,
                                          std::span<const EdgeAtPlace> at_place, double reach);

}  // namespace meshalyzer
