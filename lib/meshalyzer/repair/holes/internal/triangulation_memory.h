#pragma once

#include "meshalyzer/repair/holes/internal/loop_polygon.h"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <vector>

namespace meshalyzer {

/// Remembers the triangulations of loops, which take long: the same holes are filled in trial after
/// trial of a repair, or tried in vain again and again. Any number of threads may ask at a time.
class TriangulationMemory {
 public:
  /// Returns what triangulate_loop() returns, and computes it at the first call only for loops that
  /// differ by nothing but the numbers of their vertices. A hash stands for a loop.
  ///
  /// @complexity  O(n^2 log n) for a loop that is known, as that of triangulate_loop() for others.
  [[nodiscard]] std::optional<std::vector<Triangle>> triangulate(const LoopPolygon& polygon,
                                                                 const LoopRules& rules);

  /// Returns the number of loops that are remembered.
  [[nodiscard]] std::size_t n_known() const;

 private:
  /// The triangles by the numbers of the loop's corners; nothing if the rules permit no
  /// triangulation.
  using Triangles = std::optional<std::vector<Triangle>>;

  /// Returns what is known of a loop, which stays where it is; null if nothing is.
  [[nodiscard]] const Triangles* find_known(std::uint64_t hash) const;
  void note(std::uint64_t hash, Triangles triangles);

  /// Guards the members below.
  mutable std::mutex mutex_;
  /// By a hash of the loop.
  std::unordered_map<std::uint64_t, Triangles> known_;
  std::size_t n_triangles_ = 0;
};

}  // namespace meshalyzer
