#include "meshalyzer/spatial/closing_triangles.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/point_table.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

/// A directed edge that closing triangles must run along.
struct ClosingEdge {
  Index from = kNoIndex;
  Index to = kNoIndex;

  friend auto operator<=>(const ClosingEdge&, const ClosingEdge&) = default;
};

/// The vertices of triangles, where equal positions are one vertex.
struct MergedTriangles {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
};

MergedTriangles merge_vertices(std::span<const Corners> corners) {
  MergedTriangles merged;
  PointTable table(corners.size());
  merged.triangles.reserve(corners.size());
  for (const Corners& t : corners) {
    // The numbers must not depend on the orientation: of the last two corners the lower comes
    // first.
    const bool is_ordered =
        std::lexicographical_compare(t[1].begin(), t[1].end(), t[2].begin(), t[2].end());
    Triangle numbers{table.insert(merged.positions, t[0]), kNoIndex, kNoIndex};
    for (const std::size_t k : {is_ordered ? 1U : 2U, is_ordered ? 2U : 1U}) {
      numbers[k] = table.insert(merged.positions, t[k]);
    }
    merged.triangles.push_back(numbers);
  }
  return merged;
}

/// Returns the edges that closing triangles must run along, ascending by their lower ends: against
/// the direction in which the surface runs along them oftener, and so many times.
std::vector<ClosingEdge> find_closing_edges(std::span<const Triangle> triangles) {
  /// The lower end, the higher one, and whether the edge runs down.
  using Run = std::tuple<Index, Index, bool>;
  std::vector<Run> runs;
  runs.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = t[k];
      const Index b = t[(k + 1) % 3];
      if (a != b) runs.emplace_back(std::min(a, b), std::max(a, b), a > b);
    }
  }
  std::sort(runs.begin(), runs.end());
  std::vector<ClosingEdge> edges;
  for (auto run = runs.begin(); run != runs.end();) {
    const auto [low, high, first_runs_down] = *run;
    int n_up = 0;
    for (; run != runs.end() && std::get<0>(*run) == low && std::get<1>(*run) == high; ++run) {
      n_up += std::get<2>(*run) ? -1 : 1;
    }
    for (; n_up > 0; --n_up) edges.push_back({high, low});
    for (; n_up < 0; ++n_up) edges.push_back({low, high});
  }
  return edges;
}

/// Turns the edges of each connected part of the boundary if its first edge runs down, so that the
/// walks do not depend on the orientation of the surface.
///
/// @return  #vertices: 1 for those of parts that were turned.
std::vector<std::uint8_t> turn_downward_parts(std::size_t n_vertices,
                                              std::vector<ClosingEdge>& edges) {
  DisjointSets parts(n_vertices);
  for (const ClosingEdge& edge : edges) parts.unite(edge.from, edge.to);
  std::vector<std::uint8_t> is_seen(n_vertices, 0);
  std::vector<std::uint8_t> is_turned(n_vertices, 0);
  for (const ClosingEdge& edge : edges) {
    const Index part = parts.find(edge.from);
    if (std::exchange(is_seen[part], 1) == 0) is_turned[part] = edge.from > edge.to ? 1 : 0;
    is_turned[edge.from] = is_turned[part];
    is_turned[edge.to] = is_turned[part];
  }
  for (ClosingEdge& edge : edges) {
    if (is_turned[edge.from] != 0) std::swap(edge.from, edge.to);
  }
  return is_turned;
}

/// Takes closed walks from edges of which as many begin as end at each vertex.
class ClosedWalks {
 public:
  explicit ClosedWalks(std::size_t n_vertices, std::vector<ClosingEdge> edges)
      : edges_(std::move(edges)), next_(n_vertices + 1, 0) {
    std::sort(edges_.begin(), edges_.end());
    for (const ClosingEdge& edge : edges_) ++next_[edge.from + 1];
    for (std::size_t v = 0; v < n_vertices; ++v) next_[v + 1] += next_[v];
    end_.assign(next_.begin() + 1, next_.end());
  }

  /// Returns the vertices of the next walk; none if no edge is left.
  [[nodiscard]] std::vector<Index> take() {
    while (first_ < end_.size() && next_[first_] == end_[first_]) ++first_;
    std::vector<Index> walk;
    if (first_ == end_.size()) return walk;
    auto v = static_cast<Index>(first_);
    do {
      walk.push_back(v);
      v = edges_[next_[v]++].to;
    } while (v != first_);
    return walk;
  }

 private:
  std::vector<ClosingEdge> edges_;
  /// #vertices: where the edges from each that are left begin and end.
  std::vector<std::size_t> next_;
  std::vector<std::size_t> end_;
  std::size_t first_ = 0;
};

/// Appends triangles that run along a walk, and back from its last vertex to the first.
void close_walk(std::span<const Index> walk, std::vector<Triangle>& triangles) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, walk.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    if (last - first < 2) continue;
    const std::size_t middle = first + (last - first) / 2;
    triangles.push_back({walk[first], walk[middle], walk[last]});
    open.emplace_back(first, middle);
    open.emplace_back(middle, last);
  }
}

}  // namespace

std::vector<Corners> closing_triangles(std::span<const Corners> triangles) {
  const MergedTriangles merged = merge_vertices(triangles);
  std::vector<ClosingEdge> edges = find_closing_edges(merged.triangles);
  const std::vector<std::uint8_t> is_turned = turn_downward_parts(merged.positions.size(), edges);
  ClosedWalks walks(merged.positions.size(), std::move(edges));
  std::vector<Triangle> closing;
  for (auto walk = walks.take(); !walk.empty(); walk = walks.take()) close_walk(walk, closing);
  std::vector<Corners> result;
  result.reserve(closing.size());
  for (Triangle& t : closing) {
    if (is_turned[t[0]] != 0) std::swap(t[1], t[2]);
    result.push_back(corners_of(merged.positions, t));
  }
  return result;
}

}  // namespace meshalyzer
