#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/point_table.h"
#include "meshalyzer/base/runs.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/defects/internal/places.h"
#include "meshalyzer/mesh/edge_key.h"
#include "meshalyzer/spatial/segment_grid.h"
#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace meshalyzer {
namespace {

struct BorderEdge {
  /// The file vertices of its ends, the smaller first.
  std::array<Index, 2> ends;
  /// The mesh face at the edge.
  FaceHandle face;
};

std::vector<BorderEdge> border_edges(const CutMesh& cut) {
  std::vector<BorderEdge> edges;
  for (const HalfedgeHandle h : find_border_edges(cut)) {
    edges.push_back({ascending_file_ends(cut, h), cut.mesh.face_handle(h)});
  }
  return edges;
}

/// Names each vertex of a border edge by the lowest vertex at exactly the same place. Other
/// vertices get no name.
std::vector<Index> names_of_places(const Soup& soup, std::span<const BorderEdge> edges) {
  std::vector<Index> ends;
  ends.reserve(2 * edges.size());
  for (const BorderEdge& edge : edges) ends.insert(ends.end(), edge.ends.begin(), edge.ends.end());
  return first_equal_points(soup.positions, ends);
}

/// Collects pairs of border edges that lie on each other.
class Slits {
 public:
  explicit Slits(std::span<const BorderEdge> edges)
      : edges_(edges), sets_(edges.size()), gaps_(edges.size(), kNone) {}

  void pair(Index a, Index b, double gap) {
    // The two sides of a needle are no slit: there is a surface between them.
    if (edges_[a].face == edges_[b].face) return;
    gaps_[a] = std::min(gaps_[a], gap);
    gaps_[b] = std::min(gaps_[b], gap);
    sets_.unite(a, b);
  }
  [[nodiscard]] bool is_slit(Index edge) const { return gaps_[edge] != kNone; }

  /// Joins pairs that have a vertex in common to chains.
  void join_at_vertices(std::size_t n_vertices);
  /// Returns one defect for each chain.
  [[nodiscard]] DefectList chains(const Soup& soup, double tolerance);

 private:
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  std::span<const BorderEdge> edges_;
  DisjointSets sets_;
  /// #edges: the gap between each edge and the nearest one that it lies on.
  std::vector<double> gaps_;
};

void Slits::join_at_vertices(std::size_t n_vertices) {
  std::vector<Index> edge_at(n_vertices, kNoIndex);
  for (Index e = 0; e < edges_.size(); ++e) {
    if (!is_slit(e)) continue;
    for (const Index v : edges_[e].ends) {
      if (edge_at[v] == kNoIndex) edge_at[v] = e;
      sets_.unite(edge_at[v], e);
    }
  }
}

DefectList Slits::chains(const Soup& soup, double tolerance) {
  // Chains are numbered in order of their first edge.
  std::vector<Index> number(edges_.size(), kNoIndex);
  std::vector<Index> chain_of(edges_.size(), kNoIndex);
  Index n_chains = 0;
  for (Index e = 0; e < edges_.size(); ++e) {
    if (!is_slit(e)) continue;
    Index& chain = number[sets_.find(e)];
    if (chain == kNoIndex) chain = n_chains++;
    chain_of[e] = chain;
  }
  const ItemsByGroup chains(chain_of, n_chains);
  DefectList defects;
  for (std::size_t c = 0; c < chains.size(); ++c) {
    Defect defect = make_defect(DefectCode::Slit);
    defect.positions = {middle_of_edge(soup, edges_[chains[c].front()].ends)};
    defect.value = 0.0;
    defect.limit = tolerance;
    for (const Index e : chains[c]) {
      defect.edges.push_back(edges_[e].ends);
      defect.value = std::max(*defect.value, gaps_[e]);
    }
    defects.push_back(defect);
  }
  return defects;
}

struct NamedEdge {
  /// The names of its ends, the smaller in the upper half.
  std::uint64_t places;
  Index edge;
  friend auto operator<=>(const NamedEdge&, const NamedEdge&) = default;
};

/// Sorts border edges by their positions, so that edges at exactly the same positions follow each
/// other. Edges of length 0 are skipped.
///
/// They are grouped by the smaller names first, because few edges have the same one.
std::vector<NamedEdge> by_place(const Soup& soup, std::span<const BorderEdge> edges) {
  const std::vector<Index> names = names_of_places(soup, edges);
  const auto ends_of = [&](Index e) {
    return std::minmax(names[edges[e].ends[0]], names[edges[e].ends[1]]);
  };
  std::vector<Index> low_name(edges.size(), kNoIndex);
  for (Index e = 0; e < edges.size(); ++e) {
    const auto [low, high] = ends_of(e);
    if (low != high) low_name[e] = low;
  }
  const ItemsByGroup by_low_name(low_name, soup.n_vertices());
  std::vector<NamedEdge> named;
  named.reserve(edges.size());
  for (std::size_t group = 0; group < by_low_name.size(); ++group) {
    const auto begin = static_cast<std::ptrdiff_t>(named.size());
    for (const Index e : by_low_name[group]) {
      const auto [low, high] = ends_of(e);
      named.push_back({edge_key(low, high), e});
    }
    std::sort(named.begin() + begin, named.end());
  }
  return named;
}

/// Pairs the edges at exactly the same positions: the first of them with all others.
///
/// @return One edge for each pair of places.
std::vector<Index> pair_equal(std::span<const NamedEdge> named, std::span<const BorderEdge> edges,
                              Slits& slits) {
  std::vector<Index> firsts;
  for_each_run(named, &NamedEdge::places, [&](std::span<const NamedEdge> equal) {
    const Index first = equal[0].edge;
    firsts.push_back(first);
    Index of_other_face = kNoIndex;
    for (const NamedEdge& each : equal) {
      if (edges[each.edge].face != edges[first].face) {
        slits.pair(first, each.edge, 0.0);
        of_other_face = each.edge;
      }
    }
    if (of_other_face == kNoIndex) return;
    for (const NamedEdge& each : equal) slits.pair(each.edge, of_other_face, 0.0);
  });
  std::sort(firsts.begin(), firsts.end());
  return firsts;
}

/// The numbers of two segments that lie on each other, the lower first.
struct NearPair {
  Index first = 0;
  Index second = 0;
  double gap = 0.0;
};

/// Finds the pairs whose ends are within the tolerance, in order of their first.
std::vector<NearPair> find_near(std::span<const Segment> segments, double tolerance) {
  const SegmentGrid grid(segments, tolerance);
  return collect_chunks<NearPair>(segments.size(), [&](Chunk chunk, std::vector<NearPair>& pairs) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      grid.visit_near(segments[i], [&](Index j) {
        if (j <= i) return;
        const double gap = gap_between(segments[i], segments[j]);
        if (gap <= tolerance) pairs.push_back({static_cast<Index>(i), j, gap});
      });
    }
  });
}

/// Pairs edges whose ends are within the tolerance. It skips edges no longer than the tolerance,
/// which would be close to everything nearby.
void pair_near(const Soup& soup, std::span<const BorderEdge> edges, std::span<const Index> firsts,
               double tolerance, Slits& slits) {
  std::vector<Segment> segments;
  std::vector<Index> edge_of;
  for (const Index e : firsts) {
    const auto [a, b] = edges[e].ends;
    const Segment segment{soup.positions[a], soup.positions[b]};
    if (gap_between({segment[0], segment[0]}, {segment[1], segment[1]}) <= tolerance) continue;
    segments.push_back(segment);
    edge_of.push_back(e);
  }
  for (const NearPair& pair : find_near(segments, tolerance)) {
    slits.pair(edge_of[pair.first], edge_of[pair.second], pair.gap);
  }
}

}  // namespace

DefectList find_slits(const PreparedMesh& mesh, const Tolerances& tolerances) {
  const Soup& soup = mesh.soup();
  const std::vector<BorderEdge> edges = border_edges(mesh.cut());
  if (edges.empty()) return {};
  Slits slits(edges);
  const std::vector<Index> firsts = pair_equal(by_place(soup, edges), edges, slits);
  if (tolerances.slit > 0.0) pair_near(soup, edges, firsts, tolerances.slit, slits);
  slits.join_at_vertices(soup.n_vertices());
  return slits.chains(soup, tolerances.slit);
}

}  // namespace meshalyzer
