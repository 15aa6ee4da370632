#include "meshalyzer/repair/weld/internal/weld_chains.h"

#include "meshalyzer/spatial/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace meshalyzer {
namespace {

/// The factor between successive reaches.
constexpr double kReachStep = 8.0;
constexpr int kReachSteps = 12;
/// Where more edges than these may begin a chain, as in a crowd of short edges, none is followed.
constexpr std::size_t kMostFirstEdges = 64;

/// Follows chains along one edge.
class ChainWalk {
 public:
  ChainWalk(const NearEdges& mesh, Index edge)
      : mesh_(mesh),
        edge_(edge),
        reach_(mesh.near.reach()),
        way_(way_along(mesh, mesh.edges[edge])),
        start_(mesh.positions[from(edge)]),
        end_(mesh.positions[to(edge)]),
        backwards_((start_ - end_).stableNormalized()) {}

  /// Returns the chain of the shortest reach; nothing if there are several.
  [[nodiscard]] std::optional<WeldChain> chain() {
    const std::vector<FirstEdge> firsts = first_edges();
    if (firsts.empty() || firsts.size() > kMostFirstEdges) return std::nullopt;
    const double longest = reach_;
    for (int step = kReachSteps; step >= 0; --step) {
      reach_ = longest * std::pow(kReachStep, -step);
      std::optional<WeldChain> found;
      for (const FirstEdge& first : firsts) {
        if (first.reach > reach_) continue;
        std::optional<WeldChain> chain = follow(first.edge);
        if (!chain) continue;
        if (found) return std::nullopt;
        found = std::move(chain);
      }
      if (found) return found;
    }
    return std::nullopt;
  }

 private:
  /// An edge that a chain may begin with.
  struct FirstEdge {
    Index edge = 0;
    /// The shortest reach for which it may.
    double reach = 0.0;
  };

  /// The direction in which edges are followed: as they are, or as if all were reversed.
  enum class Way : std::uint8_t { AsIs, Reversed };

  /// A chain is followed from the end of the edge, unless many more edges are there than at its
  /// start: a fan of a million faces has as many edges at its tip.
  [[nodiscard]] static Way way_along(const NearEdges& mesh, const WeldEdge& edge) {
    constexpr std::size_t kManyMore = 8;
    const std::size_t n_at_start = mesh.at_places[mesh.places[edge.from]].size();
    const std::size_t n_at_end = mesh.at_places[mesh.places[edge.to]].size();
    return n_at_end > kManyMore * n_at_start ? Way::Reversed : Way::AsIs;
  }
  [[nodiscard]] Index from(Index f) const {
    return way_ == Way::AsIs ? mesh_.edges[f].from : mesh_.edges[f].to;
  }
  [[nodiscard]] Index to(Index f) const {
    return way_ == Way::AsIs ? mesh_.edges[f].to : mesh_.edges[f].from;
  }

  /// Returns the edges with which a chain may begin near the end of the edge.
  [[nodiscard]] std::vector<FirstEdge> first_edges() const {
    std::vector<FirstEdge> firsts;
    mesh_.near.visit_near(to(edge_), [&](Index place) {
      for (const Index f : mesh_.at_places[place]) {
        if (mesh_.places[from(f)] != place || !lies_along(f)) continue;
        const double to_end = (mesh_.positions[place] - end_).stableNorm();
        firsts.push_back({f, std::max(to_end, distance_of_end(f))});
      }
      return firsts.size() <= kMostFirstEdges;
    });
    return firsts;
  }

  [[nodiscard]] std::optional<WeldChain> follow(Index first) const {
    WeldChain chain{
        .edge = edge_, .vertices = {from(first)}, .face = mesh_.edges[first].face, .reach = reach_};
    for (Index f = first; runs_along(f);) {
      chain.vertices.push_back(to(f));
      if (is_near(to(f), start_)) {
        if (chain.vertices.size() <= 2) return std::nullopt;
        if (way_ == Way::Reversed) std::reverse(chain.vertices.begin(), chain.vertices.end());
        return chain;
      }
      const std::optional<Index> next = next_edge(f);
      if (!next) break;
      f = *next;
    }
    return std::nullopt;
  }

  /// Tells whether an edge leads on, away from the end, within reach of the long one.
  [[nodiscard]] bool runs_along(Index f) const { return !is_near(to(f), end_) && lies_along(f); }

  [[nodiscard]] bool lies_along(Index f) const {
    if (mesh_.edges[f].face == mesh_.edges[edge_].face) return false;
    const Vec3 step = mesh_.positions[to(f)] - mesh_.positions[from(f)];
    return step.dot(backwards_) > 0.0 && distance_of_end(f) <= reach_;
  }

  /// Returns the distance between the end of another edge and this one.
  [[nodiscard]] double distance_of_end(Index f) const {
    return distance_from_segment(start_, end_, mesh_.positions[to(f)]);
  }

  /// Returns the edge that continues this one at its end; nothing if there are several.
  [[nodiscard]] std::optional<Index> next_edge(Index f) const {
    std::optional<Index> next;
    const Index end = to(f);
    for (const Index g : mesh_.at_places[mesh_.places[end]]) {
      if (from(g) != end) continue;
      if (next) return std::nullopt;
      next = g;
    }
    return next;
  }

  [[nodiscard]] bool is_near(Index vertex, const Vec3& p) const {
    return (mesh_.positions[vertex] - p).stableNorm() <= reach_;
  }

  const NearEdges& mesh_;
  Index edge_;
  double reach_;
  Way way_;
  Vec3 start_;
  Vec3 end_;
  Vec3 backwards_;
};

}  // namespace

WeldCrack crack_along(std::span<const WeldEdge> edges, const WeldChain& chain) {
  const WeldEdge& edge = edges[chain.edge];
  return {.ends = {{{edge.from, chain.vertices.back()}, {edge.to, chain.vertices.front()}}},
          .splits = {{chain.edge, {chain.vertices.rbegin() + 1, chain.vertices.rend() - 1}}},
          .vertices = chain.vertices,
          .faces = {edge.face, chain.face}};
}

std::vector<WeldChain> find_weld_chains(const NearEdges& mesh, std::span<const Index> wanted) {
  std::vector<WeldChain> chains;
  for (const Index e : wanted) {
    if (auto chain = ChainWalk(mesh, e).chain()) chains.push_back(std::move(*chain));
  }
  std::stable_sort(chains.begin(), chains.end(),
                   [](const WeldChain& a, const WeldChain& b) { return a.reach < b.reach; });
  return chains;
}

}  // namespace meshalyzer
