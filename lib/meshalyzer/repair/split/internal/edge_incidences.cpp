#include "meshalyzer/repair/split/internal/edge_incidences.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/mesh/inner_halfedge.h"
#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/repair/split/internal/pair_round_edge.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The manifold components of a complex: its parts between edges with more than two faces.
struct ManifoldComponents {
  /// #mesh faces: the component of each. Faces are joined through edges with two faces, whatever
  /// their orientations.
  std::vector<Index> of_face;
  /// For each component, the fraction of border edges among the edges of its boundary; 0 if it has
  /// none.
  std::vector<double> border_share;
};

Index face_of(const CutMesh& cut, HalfedgeHandle h) {
  return static_cast<Index>(cut.mesh.face_handle(h).idx());
}

/// #mesh faces: components numbered in order of their lowest faces.
DisjointSets::Numbers number_components(const CutMesh& cut, const std::vector<EdgeKind>& kinds) {
  DisjointSets components(cut.mesh.n_faces());
  for (const EdgeHandle e : cut.mesh.edges()) {
    if (kinds[static_cast<std::size_t>(e.idx())] != EdgeKind::Inner) continue;
    components.unite(face_of(cut, cut.mesh.halfedge_handle(e, 0)),
                     face_of(cut, cut.mesh.halfedge_handle(e, 1)));
  }
  const CutEdges& flipped = cut.side.flipped_edges;
  for (std::size_t i = 0; i < flipped.size(); ++i) {
    const auto halfedges = flipped[i].halfedges;
    components.unite(face_of(cut, halfedges[0]), face_of(cut, halfedges[1]));
  }
  return components.number_all();
}

/// @complexity O(#E log #F) time, near linear in practice.
ManifoldComponents find_manifold_components(const CutMesh& cut) {
  const std::vector<EdgeKind> kinds = classify_edges(cut);
  DisjointSets::Numbers number = number_components(cut, kinds);
  const std::size_t count = number.count;
  ManifoldComponents components{.of_face = std::move(number.of), .border_share = {}};
  std::vector<double> n_rim(count, 0.0);
  std::vector<double> n_border(count, 0.0);
  for (const EdgeHandle e : cut.mesh.edges()) {
    const EdgeKind kind = kinds[static_cast<std::size_t>(e.idx())];
    if (kind != EdgeKind::Border && kind != EdgeKind::NonManifold) continue;
    const Index component = components.of_face[face_of(cut, inner_halfedge(cut.mesh, e))];
    n_rim[component] += 1.0;
    if (kind == EdgeKind::Border) n_border[component] += 1.0;
  }
  for (std::size_t i = 0; i < count; ++i) {
    components.border_share.push_back(n_border[i] / std::max(1.0, n_rim[i]));
  }
  return components;
}

/// Describes the face of an incidence as it is seen from its edge.
FaceAtEdge face_at_edge(const Soup& soup, const std::array<Index, 2>& ends, Index face) {
  const Triangle& t = soup.triangles[face];
  std::size_t i = 0;
  while (t[i] == ends[0] || t[i] == ends[1]) ++i;
  return {.apex = soup.positions[t[i]],
          .crossing = t[(i + 1) % 3] == ends[0] ? Crossing::Along : Crossing::Against};
}

/// The pairing of each edge by itself.
struct SinglePairings {
  /// #incidences: see pair_incidences().
  std::vector<Index> partner;
  /// #edges.
  std::vector<std::uint8_t> alternates;
};

SinglePairings pair_each(const TrackedMesh& tracked, const PreparedMesh& mesh,
                         const EdgeIncidences& incidences) {
  const Soup& soup = mesh.soup();
  const ManifoldComponents components = find_manifold_components(mesh.cut());
  SinglePairings result{.partner = std::vector<Index>(incidences.faces.size(), kNoIndex),
                        .alternates = std::vector<std::uint8_t>(incidences.size(), 0)};
  for (std::size_t edge = 0; edge < incidences.size(); ++edge) {
    const auto [a, b] = incidences.ends[edge];
    const bool is_sheet_cut = tracked.is_where_sheet_was_cut(a, b);
    std::vector<FaceAtEdge> faces;
    for (Index incidence = incidences.begin[edge]; incidence < incidences.begin[edge + 1];
         ++incidence) {
      FaceAtEdge& face = faces.emplace_back(
          face_at_edge(soup, incidences.ends[edge], incidences.faces[incidence]));
      face.component = components.of_face[mesh.cut().side.mesh_face(incidences.faces[incidence])];
      face.border_share = components.border_share[face.component];
      // Of sheets that cross, none is to stay whole while others end at it: a sheet whose border
      // lies within another could not be moved off it.
      if (is_sheet_cut && face.border_share > 0.0) face.border_share = 1.0;
    }
    const EdgePairing pairing = pair_round_edge(soup.positions[a], soup.positions[b], faces);
    result.alternates[edge] = pairing.alternates ? 1 : 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (pairing.partner[i] == kNoIndex) continue;
      result.partner[incidences.begin[edge] + i] = incidences.begin[edge] + pairing.partner[i];
    }
  }
  return result;
}

/// Tells how edges follow each other: for each incidence, the one that continues it beyond the
/// lower (0) and the higher (1) end of its edge; kNoIndex where the chain ends. All incidences of
/// an edge continue, or none.
using Continuations = std::array<std::vector<Index>, 2>;

/// An incidence at a vertex, and the fan with that boundary edge.
struct IncidenceEnd {
  Index fan = 0;
  Index incidence = 0;
};

/// Follows each incidence through its fan to another edge at the same vertex.
class ChainFinder {
 public:
  ChainFinder(const Soup& soup, const EdgeIncidences& incidences, const IncidentFaces& incident)
      : soup_(soup), incidences_(incidences), incident_(incident) {
    for (auto& side : next_) side.assign(incidences.faces.size(), kNoIndex);
  }

  [[nodiscard]] Continuations find() {
    for (std::size_t entry = 0; entry < incident_.size(); ++entry) link_edges_at(entry);
    return std::move(next_);
  }

 private:
  /// Lists the incidences at a vertex by fan; fans end at edges with more than two faces.
  [[nodiscard]] std::vector<IncidenceEnd> incidence_ends(std::size_t entry) const {
    std::vector<std::pair<Index, Index>> places;
    const Index v = incident_.vertex(entry);
    const auto join_none = [&](std::span<const Spoke> spokes) {
      const std::size_t edge = incidences_.edge_between(v, spokes.front().other);
      for (Index i = 0; i < spokes.size(); ++i) {
        places.emplace_back(spokes[i].place, incidences_.begin[edge] + i);
      }
      return std::vector<Index>(spokes.size(), kNoIndex);
    };
    const std::vector<Index> fans = find_fans_at(soup_, incident_, entry, join_none);
    std::vector<IncidenceEnd> ends;
    for (const auto& [place, incidence] : places) {
      ends.push_back({.fan = fans[place], .incidence = incidence});
    }
    std::stable_sort(ends.begin(), ends.end(),
                     [](const IncidenceEnd& a, const IncidenceEnd& b) { return a.fan < b.fan; });
    return ends;
  }

  /// Tells whether there are two edges, and each fan leads from one to the other.
  [[nodiscard]] bool is_chain(std::span<const IncidenceEnd> ends) const {
    if (ends.empty() || ends.size() % 2 != 0) return false;
    const auto edge = [&](std::size_t i) { return incidences_.edge_of[ends[i].incidence]; };
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

  void link_edges_at(std::size_t entry) {
    const std::vector<IncidenceEnd> ends = incidence_ends(entry);
    if (!is_chain(ends)) return;
    for (std::size_t i = 0; i < ends.size(); i += 2) {
      link(incident_.vertex(entry), ends[i].incidence, ends[i + 1].incidence);
      link(incident_.vertex(entry), ends[i + 1].incidence, ends[i].incidence);
    }
  }

  void link(Index vertex, Index from, Index to) {
    const bool is_higher_end = incidences_.ends[incidences_.edge_of[from]][1] == vertex;
    next_[is_higher_end ? 1 : 0][from] = to;
  }

  const Soup& soup_;
  const EdgeIncidences& incidences_;
  const IncidentFaces& incident_;
  Continuations next_;
};

/// Takes the pairing of one edge of each chain along the chain.
class ChainPairing {
 public:
  ChainPairing(const EdgeIncidences& incidences, const Continuations& next)
      : incidences_(incidences), next_(next), chains_(incidences.size()) {
    for (const auto& side : next_) {
      for (Index incidence = 0; incidence < side.size(); ++incidence) {
        if (side[incidence] != kNoIndex) {
          chains_.unite(incidences.edge_of[incidence], incidences.edge_of[side[incidence]]);
        }
      }
    }
  }

  /// @param is_better  Whether the pairing of an edge is preferred to that of another.
  template <typename IsBetter>
  [[nodiscard]] std::vector<Index> spread(std::vector<Index> partner, IsBetter&& is_better) {
    std::vector<Index> model(incidences_.size(), kNoIndex);
    for (Index edge = 0; edge < incidences_.size(); ++edge) {
      Index& best = model[chains_.find(edge)];
      if (best == kNoIndex || is_better(edge, best)) best = edge;
    }
    std::vector<std::uint8_t> is_done(incidences_.size(), 0);
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
        const Index first = side[incidences_.begin[edge]];
        if (first == kNoIndex || is_done[incidences_.edge_of[first]] != 0) continue;
        is_done[incidences_.edge_of[first]] = 1;
        waiting.push_back(incidences_.edge_of[first]);
        for (Index incidence = incidences_.begin[edge]; incidence < incidences_.begin[edge + 1];
             ++incidence) {
          const Index other = partner[incidence];
          partner[side[incidence]] = other == kNoIndex ? kNoIndex : side[other];
        }
      }
    }
  }

  const EdgeIncidences& incidences_;
  const Continuations& next_;
  DisjointSets chains_;
};

}  // namespace

std::size_t EdgeIncidences::edge_between(Index a, Index b) const {
  const std::array<Index, 2> wanted{std::min(a, b), std::max(a, b)};
  return static_cast<std::size_t>(std::lower_bound(ends.begin(), ends.end(), wanted) -
                                  ends.begin());
}

EdgeIncidences list_incidences(const CutMesh& cut) {
  EdgeIncidences incidences;
  const CutEdges& edges = cut.side.non_manifold_edges;
  for (Index i = 0; i < edges.size(); ++i) {
    incidences.ends.push_back(ascending_file_ends(cut, edges[i].halfedges[0]));
    for (const HalfedgeHandle h : edges[i].halfedges) {
      incidences.faces.push_back(cut.side.face(cut.mesh.face_handle(h)));
      incidences.edge_of.push_back(i);
    }
    incidences.begin.push_back(static_cast<Index>(incidences.faces.size()));
  }
  return incidences;
}

std::vector<Index> ends_of_edges(const EdgeIncidences& incidences) {
  std::vector<Index> vertices;
  for (const auto& ends : incidences.ends) {
    vertices.insert(vertices.end(), ends.begin(), ends.end());
  }
  sort_unique(vertices);
  return vertices;
}

std::vector<Index> pair_incidences(const TrackedMesh& tracked, const PreparedMesh& mesh,
                                   const EdgeIncidences& incidences,
                                   const IncidentFaces& incident) {
  SinglePairings single = pair_each(tracked, mesh, incidences);
  const auto length = [&](Index edge) {
    const auto [a, b] = incidences.ends[edge];
    return (mesh.soup().positions[a] / 2 - mesh.soup().positions[b] / 2).stableNorm();
  };
  const auto is_better = [&](Index edge, Index than) {
    if (single.alternates[edge] != single.alternates[than]) return single.alternates[edge] != 0;
    return length(edge) > length(than);
  };
  const Continuations next = ChainFinder(mesh.soup(), incidences, incident).find();
  return ChainPairing(incidences, next).spread(std::move(single.partner), is_better);
}

}  // namespace meshalyzer
