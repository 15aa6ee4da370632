#include "meshalyzer/spatial/shared_vertices.h"

#include "meshalyzer/base/items_by_group.h"
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

/// Returns the leaves of each vertex, ascending.
ItemsByGroup leaves_of_vertices(const FaceTree& tree) {
  return ItemsByGroup(tree.n_points(), [&](const auto& use) {
    for (std::size_t leaf = 0; leaf < tree.n_leaves(); ++leaf) {
      for (const LeafVertex& of_leaf : vertices_of(tree, leaf)) {
        use(of_leaf.vertex, static_cast<Index>(leaf));
      }
    }
  });
}

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

  void add(const FaceTree& tree, const CornerAngles& angles, const ItemsByGroup& leaves,
           std::size_t leaf) {
    std::vector<Index> near;
    std::size_t n_hubs = 0;
    for (const LeafVertex& of_leaf : vertices_of(tree, leaf)) {
      const std::span<const Index> its = leaves[of_leaf.vertex];
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
  const ItemsByGroup leaves = leaves_of_vertices(tree);
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
