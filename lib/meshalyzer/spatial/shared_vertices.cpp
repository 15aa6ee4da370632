#include "meshalyzer/spatial/shared_vertices.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"

#include <algorithm>
#include <optional>

namespace meshalyzer {
namespace {

/// A vertex of more leaves than this is a hub.
constexpr std::size_t kLeavesOfHub = 16;
/// The number of leaves that one task looks at: those of as many faces as other tasks have.
constexpr std::size_t kLeavesPerTask = kChunkLength / 8;

/// Returns the vertices of the faces of a leaf, ascending, each with the faces that have it.
std::vector<LeafVertex> vertices_of(const FaceTree& tree, std::size_t leaf) {
  std::vector<LeafVertex> vertices;
  const std::size_t n_faces = std::min<std::size_t>(8, tree.n_faces() - 8 * leaf);
  for (std::size_t i = 0; i < n_faces; ++i) {
    const Triangle t = tree.triangle(8 * leaf + i);
    for (unsigned c = 0; c < 3; ++c) {
      const auto same = std::find_if(vertices.begin(), vertices.end(),
                                     [&](const LeafVertex& known) { return known.vertex == t[c]; });
      LeafVertex& known = same == vertices.end() ? vertices.emplace_back() : *same;
      known.vertex = t[c];
      known.lanes |= 1U << i;
      known.corners |= c << (2 * i);
    }
  }
  std::sort(vertices.begin(), vertices.end(),
            [](const LeafVertex& a, const LeafVertex& b) { return a.vertex < b.vertex; });
  return vertices;
}

/// The leaves of each vertex, ascending.
struct LeavesOfVertices {
  std::vector<Index> leaves;
  /// #vertices + 1.
  std::vector<std::size_t> begin;

  explicit LeavesOfVertices(const FaceTree& tree) {
    const auto visit_once = [&](std::size_t leaf, const auto& visit) {
      for (const LeafVertex& of_leaf : vertices_of(tree, leaf)) visit(of_leaf.vertex);
    };
    for (std::size_t leaf = 0; leaf < tree.n_leaves(); ++leaf) {
      visit_once(leaf, [&](Index v) {
        if (v + std::size_t{2} > begin.size()) begin.resize(v + std::size_t{2}, 0);
        ++begin[v + std::size_t{1}];
      });
    }
    for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
    std::vector<std::size_t> next = begin;
    leaves.resize(begin.empty() ? 0 : begin.back());
    for (std::size_t leaf = 0; leaf < tree.n_leaves(); ++leaf) {
      visit_once(leaf, [&](Index v) { leaves[next[v]++] = static_cast<Index>(leaf); });
    }
  }

  [[nodiscard]] std::span<const Index> of(Index vertex) const {
    return std::span(leaves).subspan(begin[vertex], begin[vertex + std::size_t{1}] - begin[vertex]);
  }
};

/// Returns a range round the angles at which the faces of a leaf are seen at a vertex.
AngleRange angles_at(const LeafVertex& vertex, const CornerAngles& angles, std::size_t leaf) {
  std::optional<AngleRange> all;
  for (std::size_t i = 0; i < 8; ++i) {
    if ((vertex.lanes >> i & 1U) == 0) continue;
    const AngleRange range = angles.range(8 * leaf + i, vertex.corner(i));
    all = all ? AngleRange::around(*all, range) : range;
  }
  return all.value_or(AngleRange{});
}

/// What is known of some leaves that follow each other.
struct Part {
  std::vector<LeafVertex> hubs;
  std::vector<std::size_t> hub_counts;
  std::vector<Index> neighbours;
  std::vector<std::size_t> neighbour_counts;

  void add(const FaceTree& tree, const CornerAngles& angles, const LeavesOfVertices& leaves,
           std::size_t leaf) {
    std::vector<Index> near;
    std::size_t n_hubs = 0;
    for (const LeafVertex& of_leaf : vertices_of(tree, leaf)) {
      const std::span<const Index> its = leaves.of(of_leaf.vertex);
      if (its.size() > kLeavesOfHub) {
        hubs.push_back(of_leaf);
        hubs.back().angles = angles_at(of_leaf, angles, leaf);
        ++n_hubs;
      } else {
        near.insert(near.end(), its.begin(), its.end());
      }
    }
    sort_unique(near);
    neighbours.insert(neighbours.end(), near.begin(), near.end());
    hub_counts.push_back(n_hubs);
    neighbour_counts.push_back(near.size());
  }
};

template <typename Item>
void append(const std::vector<Item>& items, const std::vector<std::size_t>& counts,
            std::vector<Item>& all, std::vector<std::size_t>& begin) {
  all.insert(all.end(), items.begin(), items.end());
  for (const std::size_t count : counts) begin.push_back(begin.back() + count);
}

}  // namespace

SharedVertices::SharedVertices(const FaceTree& tree, const CornerAngles& angles)
    : hub_begin_{0}, neighbour_begin_{0} {
  const LeavesOfVertices leaves(tree);
  std::vector<Part> parts(n_chunks(tree.n_leaves(), kLeavesPerTask));
  parallel_chunks(tree.n_leaves(), kLeavesPerTask, [&](Chunk chunk) {
    for (std::size_t leaf = chunk.begin; leaf < chunk.end; ++leaf) {
      parts[chunk.number].add(tree, angles, leaves, leaf);
    }
  });
  for (const Part& part : parts) {
    append(part.hubs, part.hub_counts, hubs_, hub_begin_);
    append(part.neighbours, part.neighbour_counts, neighbours_, neighbour_begin_);
  }
}

}  // namespace meshalyzer
