#pragma once

#include "meshalyzer/repair/holes/internal/existing_edges.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

/// Loops made one by bridges: an annulus cut open.
struct JoinedLoop {
  HoleLoop loop;
  /// New edges, by their two vertices; the loop runs along each in both directions.
  std::vector<std::array<Index, 2>> bridges;
};

/// Joins loops to the first of them, each by a bridge between the two nearest vertices that the
/// mesh has no edge between; the nearest loop first.
///
/// @return      Nothing where two of them share a vertex, no bridge is possible, or the loops are
/// so long that looking for it would take too long.
/// @complexity  O(k n^2) for k loops of n vertices together.
[[nodiscard]] std::optional<JoinedLoop> join_loops(const Soup& soup, const ExistingEdges& existing,
                                                   std::span<const HoleLoop* const> loops);

}  // namespace meshalyzer
