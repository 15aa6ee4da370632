#include "meshalyzer/repair/holes/internal/join_loops.h"

#include <algorithm>
#include <cstddef>

namespace meshalyzer {
namespace {

/// The maximum number of pairs of vertices that are compared for all bridges of a joined loop.
constexpr std::size_t kMaxPairs = 100'000'000;

/// Appends all edges of a loop, from a corner round to the same corner again.
void append_round(const HoleLoop& from, std::size_t corner, HoleLoop& to) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::size_t at = (corner + i) % from.size();
    to.vertices.push_back(from.vertices[at]);
    to.halfedges.push_back(from.halfedges[at]);
  }
  to.vertices.push_back(from.vertices[corner]);
  to.halfedges.push_back(HalfedgeHandle());
}

HoleLoop joined(const HoleLoop& a, const HoleLoop& b, const Bridge& bridge) {
  HoleLoop result;
  append_round(a, bridge.corner_a, result);
  append_round(b, bridge.corner_b, result);
  return result;
}

bool share_vertex(std::span<const HoleLoop* const> loops) {
  std::vector<Index> vertices;
  for (const HoleLoop* loop : loops) {
    vertices.insert(vertices.end(), loop->vertices.begin(), loop->vertices.end());
  }
  std::sort(vertices.begin(), vertices.end());
  return std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
}

/// Tells whether the search for bridges stays within its bound.
bool is_affordable(std::span<const HoleLoop* const> loops) {
  std::size_t n_vertices = 0;
  for (const HoleLoop* loop : loops) n_vertices += loop->size();
  return n_vertices * n_vertices <= kMaxPairs / loops.size();
}

}  // namespace

Bridge find_bridge(const Soup& soup, const ExistingEdges& existing, const HoleLoop& a,
                   const HoleLoop& b) {
  Bridge best;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      const double length =
          (soup.positions[a.vertices[i]] - soup.positions[b.vertices[j]]).stableNorm();
      if (length < best.length && !existing.contains(a.vertices[i], b.vertices[j])) {
        best = {i, j, length};
      }
    }
  }
  return best;
}

std::optional<JoinedLoop> join_loops(const Soup& soup, const ExistingEdges& existing,
                                     std::span<const HoleLoop* const> loops) {
  if (!is_affordable(loops) || share_vertex(loops)) return std::nullopt;
  JoinedLoop result{.loop = *loops.front(), .bridges = {}};
  std::vector<const HoleLoop*> left(loops.begin() + 1, loops.end());
  while (!left.empty()) {
    Bridge best;
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const Bridge bridge = find_bridge(soup, existing, result.loop, *left[i]);
      if (bridge.length < best.length) {
        best = bridge;
        nearest = i;
      }
    }
    if (!best.is_found()) return std::nullopt;
    const HoleLoop& next = *left[nearest];
    result.bridges.push_back({result.loop.vertices[best.corner_a], next.vertices[best.corner_b]});
    result.loop = joined(result.loop, next, best);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(nearest));
  }
  return result;
}

}  // namespace meshalyzer
