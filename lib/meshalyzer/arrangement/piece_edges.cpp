#include "meshalyzer/arrangement/piece_edges.h"

#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace meshalyzer {

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

}  // namespace meshalyzer
