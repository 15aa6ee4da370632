#include "meshalyzer/arrangement/cells.h"

#include "meshalyzer/arrangement/piece_edges.h"
#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/exact/exact_point.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace meshalyzer {
namespace {

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
    const auto part = [&](const EdgeUse& use) { return 1 - turn(first, use.apex); };
    std::sort(uses.begin() + 1, uses.end(), [&](const EdgeUse& p, const EdgeUse& q) {
      const Sign part_of_p = part(p);
      const Sign part_of_q = part(q);
      if (part_of_p != part_of_q) return part_of_p < part_of_q;
      return p.piece != q.piece && turn(p, q.apex) > 0;
    });
  }

 private:
  /// Returns 1 if a vertex comes within half a turn after the piece, -1 if within half a turn
  /// before it, 0 if it is opposite.
  [[nodiscard]] Sign turn(const EdgeUse& use, Index apex) const {
    // The first source has the orientation of the piece.
    const auto plane = corners_of(soup_, arrangement_.sources_of(use.piece).front().face);
    const std::size_t n = arrangement_.n_input_vertices;
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

CellPieces::CellPieces(const Cells& cells) : pieces_(cells.of_side.size()) {
  begin_.assign(cells.count + 1, 0);
  for (const Index cell : cells.of_side) ++begin_[cell + 1];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t side = 0; side < cells.of_side.size(); ++side) {
    pieces_[next[cells.of_side[side]]++] = static_cast<Index>(side / 2);
  }
}

Cells find_cells(const Soup& soup, const Arrangement& arrangement) {
  const std::size_t n = arrangement.pieces.size();
  DisjointSets sides(2 * n);
  DisjointSets pieces(n);
  std::vector<Index> unbalanced;
  const RadialOrder order(soup, arrangement);
  PieceEdges edges(arrangement);
  for_each_edge(edges, [&](std::span<EdgeUse> uses) {
    order.sort(uses);
    int balance = 0;
    for (std::size_t i = 0; i < uses.size(); ++i) {
      const EdgeUse& next = uses[(i + 1) % uses.size()];
      if (uses.size() > 1) sides.unite(side_after(uses[i]), side_before(next));
      pieces.unite(uses[i].piece, next.piece);
      balance += uses[i].direction * arrangement.multiplicity(uses[i].piece);
    }
    if (balance != 0) unbalanced.push_back(uses[0].piece);
  });
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
