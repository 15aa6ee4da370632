#pragma once

#include "meshalyzer/repair/holes/internal/existing_edges.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

/// Several loops joined to one by bridges, like an annulus cut open.
struct JoinedLoop {
  HoleLoop loop;
  /// The new edges, by their two vertices; the loop runs along each in both directions.
  std::vector<std::array<Index, 2>> bridges;
};

/// A connection from a corner of one loop to one of another.
struct Bridge {
  std::size_t corner_a = 0;
  std::size_t corner_b = 0;
  double length = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool is_found() const { return length < std::numeric_limits<double>::infinity(); }
};

/// Returns the shortest bridge between two loops that is no edge of the mesh.
///
/// @complexity  O(n m).
[[nodiscard]] Bridge find_bridge(const Soup& soup, const ExistingEdges& existing, const HoleLoop& a,
                                 const HoleLoop& b);

/// Joins loops to the first of them, each by a bridge between the two nearest vertices without an
/// edge between them in the mesh; the nearest loop first.
///
/// @return      Nothing if two of them share a vertex, if no bridge is possible, or if the loops
/// are so long that the search would take too long.
/// @complexity  O(k n^2) for k loops of n vertices together.
[[nodiscard]] std::optional<JoinedLoop> join_loops(const Soup& soup, const ExistingEdges& existing,
                                                   std::span<const HoleLoop* const> loops);

}  // namespace meshalyzer
