#include "meshalyzer/defects/boundary_chains.h"

#include "meshalyzer/base/require.h"
#include "meshalyzer/defects/internal/places.h"
#include "meshalyzer/spatial/triangle_distance.h"
#include "meshalyzer/topology/boundary.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace meshalyzer {
namespace {

using Edge = std::array<Index, 2>;

/// Returns the vertices that a boundary passes, in walking order; a loop does not repeat the first.
std::vector<Index> vertices_of(const CutMesh& cut, const BoundaryLoop& loop) {
  Edge first = file_ends(cut, loop.halfedges[0]);
  if (loop.halfedges.size() > 1) {
    // No two border edges have both ends in common, so this determines the direction, which need
    // not be that of the half-edge.
    const Edge second = file_ends(cut, loop.halfedges[1]);
    if (first[1] != second[0] && first[1] != second[1]) std::swap(first[0], first[1]);
  }
  std::vector<Index> vertices{first[0], first[1]};
  for (std::size_t i = 1; i < loop.halfedges.size(); ++i) {
    const auto [from, to] = file_ends(cut, loop.halfedges[i]);
    vertices.push_back(from == vertices.back() ? to : from);
  }
  if (loop.shape == BoundaryShape::Loop) vertices.pop_back();
  return vertices;
}

/// Cuts walks into chains that pass no vertex twice.
class WalkCutter {
 public:
  explicit WalkCutter(std::size_t n_vertices) : place_(n_vertices, kNoIndex) {}

  /// @param walk  The vertices of the walk; a loop does not repeat the first.
  void cut(const std::vector<Index>& walk, BoundaryShape shape,
           std::vector<BoundaryChain>& chains) {
    for (const Index v : walk) {
      if (place_[v] != kNoIndex) chains.push_back({take_from(place_[v]), true});
      place_[v] = static_cast<Index>(open_.size());
      open_.push_back(v);
    }
    const bool is_closed = shape == BoundaryShape::Loop;
    std::vector<Index> rest = take_from(0);
    // A chain that ends where it began leaves its end.
    if (rest.size() > 1) chains.push_back({std::move(rest), is_closed});
  }

 private:
  /// Removes the vertices from a position on from open_ and returns them.
  std::vector<Index> take_from(std::size_t begin) {
    std::vector<Index> taken(open_.begin() + static_cast<std::ptrdiff_t>(begin), open_.end());
    open_.resize(begin);
    for (const Index v : taken) place_[v] = kNoIndex;
    return taken;
  }

  /// Vertices that have been passed and are in no finished loop.
  std::vector<Index> open_;
  /// #V: the position of each vertex in open_; kNoIndex if it is not there.
  std::vector<Index> place_;
};

std::size_t n_edges(const BoundaryChain& chain) {
  return chain.is_closed ? chain.vertices.size() : chain.vertices.size() - 1;
}

/// Returns edge i of a chain, the smaller vertex first.
Edge edge_of(const BoundaryChain& chain, std::size_t i) {
  const Index a = chain.vertices[i];
  const Index b = chain.vertices[i + 1 < chain.vertices.size() ? i + 1 : 0];
  return {std::min(a, b), std::max(a, b)};
}

std::size_t lowest_edge(const BoundaryChain& chain) {
  std::size_t lowest = 0;
  for (std::size_t i = 1; i < n_edges(chain); ++i) {
    if (edge_of(chain, i) < edge_of(chain, lowest)) lowest = i;
  }
  return lowest;
}

/// Begins each closed chain with its lowest edge, and sorts all by that.
void sort_chains(std::vector<BoundaryChain>& chains) {
  std::vector<std::pair<Edge, std::size_t>> order;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    BoundaryChain& chain = chains[i];
    const std::size_t lowest = lowest_edge(chain);
    order.emplace_back(edge_of(chain, lowest), i);
    if (!chain.is_closed) continue;
    std::rotate(chain.vertices.begin(),
                chain.vertices.begin() + static_cast<std::ptrdiff_t>(lowest), chain.vertices.end());
  }
  std::sort(order.begin(), order.end());
  std::vector<BoundaryChain> sorted;
  sorted.reserve(chains.size());
  for (const auto& entry : order) sorted.push_back(std::move(chains[entry.second]));
  chains = std::move(sorted);
}

double distance(const Soup& soup, const BoundaryChain& chain, const Vec3& from) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n_edges(chain); ++i) {
    const auto [a, b] = edge_of(chain, i);
    const double here = distance_from_segment(soup.positions[a], soup.positions[b], from);
    nearest = std::min(nearest, here);
  }
  return nearest;
}

std::vector<BoundaryChain> nearest_chains(const Soup& soup,
                                          const std::vector<BoundaryChain>& chains,
                                          const std::vector<Vec3>& positions) {
  std::vector<BoundaryChain> nearest;
  std::vector<std::uint8_t> is_taken(chains.size(), 0);
  for (const Vec3& position : positions) {
    std::size_t best = 0;
    double best_distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < chains.size(); ++i) {
      const double d = distance(soup, chains[i], position);
      if (d < best_distance) {
        best = i;
        best_distance = d;
      }
    }
    if (chains.empty() || is_taken[best] != 0) continue;
    is_taken[best] = 1;
    nearest.push_back(chains[best]);
  }
  return nearest;
}

}  // namespace

std::vector<BoundaryChain> find_boundary_chains(const PreparedMesh& mesh,
                                                const ChainOptions& options) {
  for (const Vec3& near : options.near_positions) require_point("a position of a chain", near);
  const CutMesh& cut = mesh.cut();
  std::vector<BoundaryChain> chains;
  const BoundaryLoops loops = find_boundary_loops(cut);
  if (loops.empty()) return chains;
  WalkCutter cutter(cut.side.n_file_vertices);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    cutter.cut(vertices_of(cut, loops[i]), loops[i].shape, chains);
  }
  sort_chains(chains);
  if (options.max_edges != 0) {
    std::erase_if(chains, [&](const BoundaryChain& c) { return n_edges(c) > options.max_edges; });
  }
  if (options.near_positions.empty()) return chains;
  return nearest_chains(mesh.soup(), chains, options.near_positions);
}

}  // namespace meshalyzer
