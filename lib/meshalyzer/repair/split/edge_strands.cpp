#include "meshalyzer/repair/split/edge_strands.h"

#include "meshalyzer/repair/split/pair_round_edge.h"
#include "meshalyzer/repair/split/surface_patches.h"
#include "meshalyzer/topology/disjoint_sets.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace meshalyzer {
namespace {

/// The face of a strand as it is seen from its edge.
FaceAtEdge face_at_edge(const Soup& soup, const std::array<Index, 2>& ends, Index face) {
  const Triangle& t = soup.triangles[face];
  std::size_t i = 0;
  while (t[i] == ends[0] || t[i] == ends[1]) ++i;
  return {.apex = soup.positions[t[i]],
          .crossing = t[(i + 1) % 3] == ends[0] ? Crossing::Along : Crossing::Against};
}

/// The pairing of each edge for itself.
struct SinglePairings {
  /// #strands: see pair_strands().
  std::vector<Index> partner;
  /// #edges.
  std::vector<std::uint8_t> alternates;
};

SinglePairings pair_each(const PreparedMesh& mesh, const EdgeStrands& strands) {
  const Soup& soup = mesh.soup();
  const SurfacePatches patches = find_surface_patches(mesh.cut());
  SinglePairings result{.partner = std::vector<Index>(strands.faces.size(), kNoIndex),
                        .alternates = std::vector<std::uint8_t>(strands.size(), 0)};
  for (std::size_t edge = 0; edge < strands.size(); ++edge) {
    std::vector<FaceAtEdge> faces;
    for (Index strand = strands.begin[edge]; strand < strands.begin[edge + 1]; ++strand) {
      FaceAtEdge& face =
          faces.emplace_back(face_at_edge(soup, strands.ends[edge], strands.faces[strand]));
      face.patch = patches.of_face[mesh.cut().side.mesh_face(strands.faces[strand])];
      face.openness = patches.openness[face.patch];
    }
    const auto [a, b] = strands.ends[edge];
    const EdgePairing pairing = pair_round_edge(soup.positions[a], soup.positions[b], faces);
    result.alternates[edge] = pairing.alternates ? 1 : 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (pairing.partner[i] == kNoIndex) continue;
      result.partner[strands.begin[edge] + i] = strands.begin[edge] + pairing.partner[i];
    }
  }
  return result;
}

/// How edges follow each other: for each strand, what it goes on as beyond the lower (0) and the
/// higher (1) end of its edge; kNoIndex where the chain ends. All strands of an edge go on, or
/// none.
using Continuations = std::array<std::vector<Index>, 2>;

/// The strands at a star's vertex, and the fan that each is on the rim of.
struct StrandEnd {
  Index fan = 0;
  Index strand = 0;
};

/// Follows each strand through its fan to another edge at the star's vertex.
class ChainFinder {
 public:
  ChainFinder(const Soup& soup, const EdgeStrands& strands, const VertexStars& stars)
      : soup_(soup), strands_(strands), stars_(stars) {
    for (auto& side : next_) side.assign(strands.faces.size(), kNoIndex);
  }

  [[nodiscard]] Continuations find() {
    for (std::size_t star = 0; star < stars_.size(); ++star) link_edges_at(star);
    return std::move(next_);
  }

 private:
  /// The strands at the vertex of a star, by fan where no edge with more than two faces joins any.
  [[nodiscard]] std::vector<StrandEnd> strand_ends(std::size_t star) const {
    std::vector<std::pair<Index, Index>> places;
    const Index v = stars_.vertex(star);
    const auto join_none = [&](std::span<const Spoke> spokes) {
      const std::size_t edge = strands_.edge_between(v, spokes.front().other);
      for (Index i = 0; i < spokes.size(); ++i) {
        places.emplace_back(spokes[i].place, strands_.begin[edge] + i);
      }
      return std::vector<Index>(spokes.size(), kNoIndex);
    };
    const std::vector<Index> fans = find_fans_of_star(soup_, stars_, star, join_none);
    std::vector<StrandEnd> ends;
    for (const auto& [place, strand] : places) {
      ends.push_back({.fan = fans[place], .strand = strand});
    }
    std::stable_sort(ends.begin(), ends.end(),
                     [](const StrandEnd& a, const StrandEnd& b) { return a.fan < b.fan; });
    return ends;
  }

  /// Whether there are two edges, and each fan leads from one to the other.
  [[nodiscard]] bool is_chain(std::span<const StrandEnd> ends) const {
    if (ends.empty() || ends.size() % 2 != 0) return false;
    const auto edge = [&](std::size_t i) { return strands_.edge_of[ends[i].strand]; };
    const Index low = std::min(edge(0), edge(1));
    const Index high = std::max(edge(0), edge(1));
    if (low == high) return false;
    for (std::size_t i = 0; i < ends.size(); i += 2) {
      if (ends[i].fan != ends[i + 1].fan) return false;
      if (i > 0 && ends[i].fan == ends[i - 1].fan) return false;
      if (std::min(edge(i), edge(i + 1)) != low || std::max(edge(i), edge(i + 1)) != high) {
        return false;
      }
    }
    return true;
  }

  void link_edges_at(std::size_t star) {
    const std::vector<StrandEnd> ends = strand_ends(star);
    if (!is_chain(ends)) return;
    for (std::size_t i = 0; i < ends.size(); i += 2) {
      link(stars_.vertex(star), ends[i].strand, ends[i + 1].strand);
      link(stars_.vertex(star), ends[i + 1].strand, ends[i].strand);
    }
  }

  void link(Index vertex, Index from, Index to) {
    const bool is_higher_end = strands_.ends[strands_.edge_of[from]][1] == vertex;
    next_[is_higher_end ? 1 : 0][from] = to;
  }

  const Soup& soup_;
  const EdgeStrands& strands_;
  const VertexStars& stars_;
  Continuations next_;
};

/// Takes the pairing of one edge of each chain along the chain.
class ChainPairing {
 public:
  ChainPairing(const EdgeStrands& strands, const Continuations& next)
      : strands_(strands), next_(next), chains_(strands.size()) {
    for (const auto& side : next_) {
      for (Index strand = 0; strand < side.size(); ++strand) {
        if (side[strand] != kNoIndex) {
          chains_.unite(strands.edge_of[strand], strands.edge_of[side[strand]]);
        }
      }
    }
  }

  /// @param is_better  Whether an edge should be asked rather than another.
  template <typename IsBetter>
  [[nodiscard]] std::vector<Index> spread(std::vector<Index> partner, IsBetter&& is_better) {
    std::vector<Index> model(strands_.size(), kNoIndex);
    for (Index edge = 0; edge < strands_.size(); ++edge) {
      Index& best = model[chains_.find(edge)];
      if (best == kNoIndex || is_better(edge, best)) best = edge;
    }
    std::vector<std::uint8_t> is_done(strands_.size(), 0);
    for (const Index edge : model) {
      if (edge != kNoIndex) spread_from(edge, is_done, partner);
    }
    return partner;
  }

 private:
  void spread_from(Index model, std::vector<std::uint8_t>& is_done,
                   std::vector<Index>& partner) const {
    std::vector<Index> waiting{model};
    is_done[model] = 1;
    while (!waiting.empty()) {
      const Index edge = waiting.back();
      waiting.pop_back();
      for (const auto& side : next_) {
        const Index first = side[strands_.begin[edge]];
        if (first == kNoIndex || is_done[strands_.edge_of[first]] != 0) continue;
        is_done[strands_.edge_of[first]] = 1;
        waiting.push_back(strands_.edge_of[first]);
        for (Index strand = strands_.begin[edge]; strand < strands_.begin[edge + 1]; ++strand) {
          const Index other = partner[strand];
          partner[side[strand]] = other == kNoIndex ? kNoIndex : side[other];
        }
      }
    }
  }

  const EdgeStrands& strands_;
  const Continuations& next_;
  DisjointSets chains_;
};

}  // namespace

std::size_t EdgeStrands::edge_between(Index a, Index b) const {
  const std::array<Index, 2> wanted{std::min(a, b), std::max(a, b)};
  return static_cast<std::size_t>(std::lower_bound(ends.begin(), ends.end(), wanted) -
                                  ends.begin());
}

EdgeStrands list_strands(const CutMesh& cut) {
  EdgeStrands strands;
  const CutEdges& edges = cut.side.non_manifold_edges;
  for (Index i = 0; i < edges.size(); ++i) {
    auto ends = file_ends(cut, edges[i].halfedges[0]);
    std::sort(ends.begin(), ends.end());
    strands.ends.push_back(ends);
    for (const HalfedgeHandle h : edges[i].halfedges) {
      strands.faces.push_back(cut.side.face(cut.mesh.face_handle(h)));
      strands.edge_of.push_back(i);
    }
    strands.begin.push_back(static_cast<Index>(strands.faces.size()));
  }
  return strands;
}

std::vector<Index> ends_of_strands(const EdgeStrands& strands) {
  std::vector<Index> vertices;
  for (const auto& ends : strands.ends) vertices.insert(vertices.end(), ends.begin(), ends.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

std::vector<Index> pair_strands(const PreparedMesh& mesh, const EdgeStrands& strands,
                                const VertexStars& stars) {
  SinglePairings single = pair_each(mesh, strands);
  const auto length = [&](Index edge) {
    const auto [a, b] = strands.ends[edge];
    return (mesh.soup().positions[a] / 2 - mesh.soup().positions[b] / 2).stableNorm();
  };
  const auto is_better = [&](Index edge, Index than) {
    if (single.alternates[edge] != single.alternates[than]) return single.alternates[edge] != 0;
    return length(edge) > length(than);
  };
  const Continuations next = ChainFinder(mesh.soup(), strands, stars).find();
  return ChainPairing(strands, next).spread(std::move(single.partner), is_better);
}

}  // namespace meshalyzer
