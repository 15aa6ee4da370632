#include "meshalyzer/repair/weld/internal/weld_cracks.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/spatial/triangle_distance.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

namespace meshalyzer {
namespace {

/// Chains with more edges are not followed.
constexpr std::size_t kMaxCrackEdges = 64;
/// Where more edges than these meet, as at the tip of a fan, no crack is followed.
constexpr std::size_t kMaxPartners = 16;

/// One side of a crack, followed from its beginning, along its edges or against them.
struct CrackSide {
  bool runs_along = true;
  std::vector<EdgeSplit> splits;
  /// The vertices that have been passed.
  std::vector<Index> vertices;
};

/// Follows two chains of border edges from a place where they meet.
class CrackWalk {
 public:
  CrackWalk(const NearEdges& mesh, Index along, Index against)
      : mesh_(mesh),
        a_{.runs_along = true, .splits = {}, .vertices = {}},
        b_{.runs_along = false, .splits = {}, .vertices = {}} {
    begin(a_, along);
    begin(b_, against);
  }

  /// Returns the crack up to the next place where the chains meet; nothing if they part before, or
  /// if one of them has no vertices on the way.
  [[nodiscard]] std::optional<WeldCrack> crack() {
    while (!are_near(next(a_), next(b_))) {
      if (a_.splits.size() + b_.splits.size() > kMaxCrackEdges) return std::nullopt;
      if (!pass_vertex(a_, b_) && !pass_vertex(b_, a_)) return std::nullopt;
    }
    if (a_.splits.size() < 2 || b_.splits.size() < 2) return std::nullopt;
    a_.vertices.push_back(next(a_));
    b_.vertices.push_back(next(b_));
    return made_crack();
  }

 private:
  void begin(CrackSide& side, Index edge) const {
    side.splits.push_back({edge, {}});
    const WeldEdge& e = mesh_.edges[edge];
    side.vertices.push_back(side.runs_along ? e.from : e.to);
  }

  /// Returns the vertex at the far end of the current edge of a side.
  [[nodiscard]] Index next(const CrackSide& side) const {
    const WeldEdge& e = mesh_.edges[side.splits.back().edge];
    return side.runs_along ? e.to : e.from;
  }

  [[nodiscard]] bool are_near(Index v, Index w) const {
    return (mesh_.positions[v] - mesh_.positions[w]).stableNorm() <= mesh_.near.reach();
  }

  /// Assigns the next vertex of a side to the edge of the other one, if it lies along that.
  ///
  /// @return Whether it does, and the side continues behind it.
  [[nodiscard]] bool pass_vertex(CrackSide& side, CrackSide& other) const {
    const Index vertex = next(side);
    const Index begin = other.splits.back().inner.empty() ? other.vertices.back()
                                                          : other.splits.back().inner.back();
    if (!lies_between(vertex, begin, next(other))) return false;
    const std::optional<Index> edge = next_edge(side, vertex);
    if (!edge) return false;
    other.splits.back().inner.push_back(vertex);
    side.vertices.push_back(vertex);
    side.splits.push_back({*edge, {}});
    return true;
  }

  /// Tells whether a vertex is within reach of the segment between two others, but not of these.
  [[nodiscard]] bool lies_between(Index vertex, Index from, Index to) const {
    if (are_near(vertex, from) || are_near(vertex, to)) return false;
    const Vec3& a = mesh_.positions[from];
    const Vec3& b = mesh_.positions[to];
    const Vec3& p = mesh_.positions[vertex];
    return (p - a).dot(b - a) > 0.0 && (p - b).dot(a - b) > 0.0 &&
           distance_from_segment(a, b, p) <= mesh_.near.reach();
  }

  /// Returns the edge of a side behind a vertex; nothing unless there is exactly one.
  [[nodiscard]] std::optional<Index> next_edge(const CrackSide& side, Index vertex) const {
    std::optional<Index> found;
    for (const Index e : mesh_.at_places[mesh_.places[vertex]]) {
      if ((side.runs_along ? mesh_.edges[e].from : mesh_.edges[e].to) != vertex) continue;
      if (found) return std::nullopt;
      found = e;
    }
    return found;
  }

  /// Returns the crack; nothing if a vertex or face occurs twice.
  [[nodiscard]] std::optional<WeldCrack> made_crack() {
    WeldCrack crack{.ends = {{{a_.vertices.front(), b_.vertices.front()},
                              {a_.vertices.back(), b_.vertices.back()}}},
                    .splits = {},
                    .vertices = {},
                    .faces = {}};
    for (EdgeSplit& split : b_.splits) std::reverse(split.inner.begin(), split.inner.end());
    for (CrackSide* side : {&a_, &b_}) {
      crack.vertices.insert(crack.vertices.end(), side->vertices.begin(), side->vertices.end());
      for (EdgeSplit& split : side->splits) {
        crack.faces.push_back(mesh_.edges[split.edge].face);
        if (!split.inner.empty()) crack.splits.push_back(std::move(split));
      }
    }
    if (repeats_any(crack)) return std::nullopt;
    return crack;
  }

  [[nodiscard]] static bool repeats_any(const WeldCrack& crack) {
    std::vector<Index> faces = crack.faces;
    std::vector<Index> vertices = crack.vertices;
    sort_unique(faces);
    sort_unique(vertices);
    const auto n_joined = static_cast<std::size_t>(
        std::count_if(crack.ends.begin(), crack.ends.end(),
                      [](const std::array<Index, 2>& end) { return end[0] == end[1]; }));
    return faces.size() != crack.faces.size() ||
           vertices.size() + n_joined != crack.vertices.size();
  }

  const NearEdges& mesh_;
  CrackSide a_;
  CrackSide b_;
};

/// Returns the edges that run to a place near the start of an edge; none if there are many.
std::vector<Index> partners_of(const NearEdges& mesh, Index edge) {
  std::vector<Index> partners;
  bool are_many = false;
  mesh.near.visit_near(mesh.edges[edge].from, [&](Index place) {
    const std::span<const Index> there = mesh.at_places[place];
    are_many = partners.size() + there.size() > kMaxPartners;
    if (are_many) return false;
    std::copy_if(there.begin(), there.end(), std::back_inserter(partners),
                 [&](Index e) { return e != edge && mesh.places[mesh.edges[e].to] == place; });
    return true;
  });
  if (are_many) return {};
  std::sort(partners.begin(), partners.end());
  return partners;
}

}  // namespace

std::vector<WeldCrack> find_interleaved_cracks(const NearEdges& mesh,
                                               std::span<const Index> wanted) {
  std::vector<WeldCrack> cracks;
  for (const Index e : wanted) {
    for (const Index f : partners_of(mesh, e)) {
      if (auto crack = CrackWalk(mesh, e, f).crack()) cracks.push_back(std::move(*crack));
    }
  }
  return cracks;
}

}  // namespace meshalyzer
