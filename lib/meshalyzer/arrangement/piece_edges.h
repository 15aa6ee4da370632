#pragma once

#include "meshalyzer/arrangement/arrangement.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// An edge of a piece, as stored at its lower vertex.
struct EdgeUse {
  Index high = kNoIndex;
  Index piece = kNoIndex;
  /// The corner of the piece opposite to the edge.
  Index apex = kNoIndex;
  /// 1 if the piece traverses the edge from the lower vertex to the higher one, else -1.
  Sign direction = 1;
};

/// The edges of pieces, grouped by their lower vertices.
class PieceEdges {
 public:
  /// @complexity O(#vertices + #pieces), apart from sorting round each vertex.
  explicit PieceEdges(const Arrangement& arrangement);

  [[nodiscard]] std::size_t n_vertices() const { return begin_.size() - 1; }
  /// Returns all uses of edges with this lower vertex, ascending by higher vertex, then by piece.
  [[nodiscard]] std::span<EdgeUse> of(std::size_t vertex) {
    return std::span(uses_).subspan(begin_[vertex], begin_[vertex + 1] - begin_[vertex]);
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<EdgeUse> uses_;
};

/// Calls `body` with the uses of each edge, edge by edge.
template <typename Body>
void for_each_edge(PieceEdges& edges, const Body& body) {
  for (std::size_t v = 0; v < edges.n_vertices(); ++v) {
    const std::span<EdgeUse> uses = edges.of(v);
    for (std::size_t first = 0; first < uses.size();) {
      std::size_t end = first + 1;
      while (end < uses.size() && uses[end].high == uses[first].high) ++end;
      body(uses.subspan(first, end - first));
      first = end;
    }
  }
}

}  // namespace meshalyzer
