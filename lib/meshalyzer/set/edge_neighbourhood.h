#pragma once

#include "meshalyzer/spatial/face_tree.h"

#include <cstdint>
#include <functional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {

/// The faces at each file vertex, in one flat list.
class FacesAtVertices {
 public:
  /// @complexity O(#V + #F).
  FacesAtVertices(const FaceTree& tree, std::size_t n_file_vertices);

  [[nodiscard]] std::size_t n_vertices() const { return begin_.size() - 1; }
  /// Slots of the tree, ascending.
  [[nodiscard]] std::span<const Index> slots(Index file_vertex) const {
    return std::span(slots_).subspan(begin_[file_vertex],
                                     begin_[file_vertex + 1] - begin_[file_vertex]);
  }

 private:
  std::vector<Index> begin_;
  std::vector<Index> slots_;
};

/// Finds the faces round a vertex within a length along edges. Keeps its memory from one vertex to
/// the next; one thread uses it.
class EdgeNeighbourhood {
 public:
  EdgeNeighbourhood(const FaceTree& tree, const FacesAtVertices& faces);

  /// Marks the mesh faces that have a vertex which a path of edges no longer than `length` leads
  /// to; the faces at the vertex itself are always among them.
  ///
  /// Shortest paths by Dijkstra (1959).
  /// @return     #mesh faces, 1 for those; valid until the next call.
  /// @complexity O(k log k) for k faces marked.
  [[nodiscard]] std::span<const std::uint8_t> mark_within(Index file_vertex, double length);

 private:
  void reach(Index vertex, double length);
  void go_on_from(Index vertex, double length_limit);
  void reset();

  const FaceTree& tree_;
  const FacesAtVertices& faces_;
  /// #V; infinite where not reached.
  std::vector<double> length_to_;
  std::vector<Index> reached_;
  std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>,
                      std::greater<>>
      next_;
  /// #mesh faces.
  std::vector<std::uint8_t> is_marked_;
};

}  // namespace meshalyzer
