#pragma once

#include "meshalyzer/repair/holes/internal/loop_polygon.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace meshalyzer {

/// Remembers the triangulations of loops, which take long: the same holes are filled in trial after
/// trial of a repair, or tried in vain again and again.
class TriangulationMemory {
 public:
  /// Returns what triangulate_loop() returns, and computes it at the first call only for loops that
  /// differ by nothing but the numbers of their vertices. A hash stands for a loop.
  ///
  /// @complexity  O(n^2 log n) for a loop that is known, as that of triangulate_loop() for others.
  [[nodiscard]] std::optional<std::vector<Triangle>> triangulate(const LoopPolygon& polygon,
                                                                 const LoopRules& rules);

  /// Returns the number of loops that are remembered.
  [[nodiscard]] std::size_t n_known() const { return known_.size(); }

 private:
  /// By a hash of the loop: the triangles by the numbers of its corners; nothing if the rules
  /// permit no triangulation.
  std::unordered_map<std::uint64_t, std::optional<std::vector<Triangle>>> known_;
  std::size_t n_triangles_ = 0;
};

}  // namespace meshalyzer
