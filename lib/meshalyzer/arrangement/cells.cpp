#include "meshalyzer/arrangement/cells.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/runs.h"
#include "meshalyzer/exact/exact_point.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Vertices in one task: to sort the pieces round an edge takes some microseconds.
constexpr std::size_t kVerticesAtOnce = 1024;

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

PieceEdges::PieceEdges(const Arrangement& arrangement)
    : begin_(arrangement.positions.size() + 1, 0), uses_(3 * arrangement.pieces.size()) {
  for (const Triangle& t : arrangement.pieces) {
    for (std::size_t k = 0; k < 3; ++k) ++begin_[std::min(t[k], t[(k + 1) % 3]) + 1];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (Index piece = 0; piece < arrangement.pieces.size(); ++piece) {
    const Triangle& t = arrangement.pieces[piece];
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = t[k];
      const Index to = t[(k + 1) % 3];
      uses_[next[std::min(from, to)]++] = {.high = std::max(from, to),
                                           .piece = piece,
                                           .apex = t[(k + 2) % 3],
                                           .direction = from < to ? 1 : -1};
    }
  }
  parallel_chunks(n_vertices(), [&](Chunk chunk) {
    for (std::size_t v = chunk.begin; v < chunk.end; ++v) {
      const std::span<EdgeUse> uses = of(v);
      std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
        return std::pair(a.high, a.piece) < std::pair(b.high, b.piece);
      });
    }
  });
}

/// Calls `body` with the uses of each edge, edge by edge.
///
/// @param uses  The uses of all edges with the same lower vertex.
template <typename Body>
void for_each_edge(std::span<EdgeUse> uses, const Body& body) {
  for_each_run(uses, &EdgeUse::high, body);
}

/// The order of pieces round an edge.
class RadialOrder {
 public:
  RadialOrder(const Soup& soup, const Arrangement& arrangement)
      : soup_(soup), arrangement_(arrangement) {}

  /// Sorts the uses of one edge counter-clockwise when viewed against the direction from its lower
  /// vertex to the higher one.
  void sort(std::span<EdgeUse> uses) const {
    if (uses.size() < 3) return;
    const EdgeUse first = uses[0];
    const auto part = [&](const EdgeUse& use) { return 1 - turn(first, use); };
    std::sort(uses.begin() + 1, uses.end(), [&](const EdgeUse& p, const EdgeUse& q) {
      const Sign part_of_p = part(p);
      const Sign part_of_q = part(q);
      if (part_of_p != part_of_q) return part_of_p < part_of_q;
      return p.piece != q.piece && turn(p, q) > 0;
    });
  }

 private:
  /// Returns 1 if a piece comes within half a turn after another, -1 if within half a turn before
  /// it, 0 if it is opposite.
  [[nodiscard]] Sign turn(const EdgeUse& use, const EdgeUse& other) const {
    // The first source has the orientation of the piece.
    const Index face = arrangement_.sources_of(use.piece).front().face;
    // Pieces of one face do not overlap, so that each is opposite to the other.
    if (arrangement_.sources_of(other.piece).front().face == face) return 0;
    const auto plane = corners_of(soup_, face);
    const std::size_t n = arrangement_.n_input_vertices;
    const Index apex = other.apex;
    const Sign side =
        apex < n ? orient3d(plane[0], plane[1], plane[2], soup_.positions[apex])
                 : orient3d(plane[0], plane[1], plane[2], arrangement_.exact.made(apex - n));
    return side * use.direction;
  }

  const Soup& soup_;
  const Arrangement& arrangement_;
};

/// Returns the side of a piece that follows counter-clockwise round its edge.
Index side_after(const EdgeUse& use) {
  return 2 * use.piece + (use.direction > 0 ? 0 : 1);
}
Index side_before(const EdgeUse& use) {
  return 2 * use.piece + (use.direction > 0 ? 1 : 0);
}

}  // namespace

ItemsByGroup pieces_by_cell(const Cells& cells) {
  return ItemsByGroup(cells.count, [&](const auto& use) {
    for (std::size_t side = 0; side < cells.of_side.size(); ++side) {
      use(cells.of_side[side], static_cast<Index>(side / 2));
    }
  });
}

Cells find_cells(const Soup& soup, const Arrangement& arrangement) {
  const std::size_t n = arrangement.pieces.size();
  DisjointSets sides(2 * n);
  DisjointSets pieces(n);
  std::vector<Index> unbalanced;
  const RadialOrder order(soup, arrangement);
  PieceEdges edges(arrangement);
  parallel_chunks(edges.n_vertices(), kVerticesAtOnce, [&](Chunk chunk) {
    for (std::size_t v = chunk.begin; v < chunk.end; ++v) {
      for_each_edge(edges.of(v), [&](std::span<EdgeUse> uses) { order.sort(uses); });
    }
  });
  const auto join_sides = [&](std::span<EdgeUse> uses) {
    int balance = 0;
    for (std::size_t i = 0; i < uses.size(); ++i) {
      const EdgeUse& next = uses[(i + 1) % uses.size()];
      if (uses.size() > 1) sides.unite(side_after(uses[i]), side_before(next));
      pieces.unite(uses[i].piece, next.piece);
      balance += uses[i].direction * arrangement.multiplicity(uses[i].piece);
    }
    if (balance != 0) unbalanced.push_back(uses[0].piece);
  };
  for (std::size_t v = 0; v < edges.n_vertices(); ++v) for_each_edge(edges.of(v), join_sides);
  DisjointSets::Numbers cell = sides.number_all();
  DisjointSets::Numbers component = pieces.number_all();
  Cells cells;
  cells.of_side = std::move(cell.of);
  cells.count = cell.count;
  cells.component_of = std::move(component.of);
  cells.n_components = component.count;
  cells.is_closed.assign(cells.n_components, 1);
  for (const Index piece : unbalanced) cells.is_closed[cells.component_of[piece]] = 0;
  return cells;
}

}  // namespace meshalyzer
