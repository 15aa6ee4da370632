#pragma once

#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/spatial/face_tree.h"

#include <cstdint>
#include <functional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {

/// Returns the slots in the tree of the faces at each file vertex, ascending.
///
/// @complexity O(#V + #F).
[[nodiscard]] ItemsByGroup slots_by_vertex(const FaceTree& tree, std::size_t n_file_vertices);

/// Finds the faces round a vertex within a length along edges. It reuses its memory for the next
/// vertex, and only one thread may use it.
class EdgeNeighbourhood {
 public:
  /// @param slots  The result of slots_by_vertex().
  EdgeNeighbourhood(const FaceTree& tree, const ItemsByGroup& slots);

  /// Marks the mesh faces with a vertex within `length` of the given one along edges, always
  /// including the faces at the vertex itself.
  ///
  /// Shortest paths by Dijkstra (1959).
  /// @return     #mesh faces: 1 for marked ones; valid until the next call.
  /// @complexity O(k log k) for k faces marked.
  [[nodiscard]] std::span<const std::uint8_t> mark_within(Index file_vertex, double length);

 private:
  void reach(Index vertex, double length);
  void go_on_from(Index vertex, double length_limit);
  void reset();

  const FaceTree& tree_;
  const ItemsByGroup& slots_;
  /// #V: the length of the shortest path; infinite if not reached.
  std::vector<double> length_to_;
  std::vector<Index> reached_;
  std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>,
                      std::greater<>>
      next_;
  /// #mesh faces: 1 for marked ones.
  std::vector<std::uint8_t> is_marked_;
};

}  // namespace meshalyzer
