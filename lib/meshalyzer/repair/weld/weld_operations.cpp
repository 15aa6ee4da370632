#include "meshalyzer/repair/weld/weld_operations.h"

#include "meshalyzer/repair/weld/weld_check.h"
#include "meshalyzer/topology/disjoint_sets.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

/// Of joins that do harm the farthest are dropped. After so many trials whatever hangs together
/// with what does harm goes with it: then nothing is left of it that could do harm in another way.
constexpr std::size_t kMaxJoinTrials = 8;
/// Joins are added in steps where they do harm together: in each those of edges that are up to so
/// many times as far apart as the nearest, in the last one all that are left.
constexpr double kJoinStep = 8.0;
constexpr std::size_t kMaxJoinSteps = 6;

/// Joins as they would be made.
struct JoinedMesh {
  /// #V, the vertex that stays of those that each becomes one with.
  std::vector<Index> staying;
  /// Faces of the complex with a joined vertex, ascending.
  std::vector<Index> touched;
};

std::vector<Index> find_touched(const Soup& soup, const WeldClasses& classes) {
  std::vector<Index> touched;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const Triangle& t = soup.triangles[f];
    if (!is_in_complex(t)) continue;
    const auto is_joined = [&](Index v) { return !classes.is_alone(v); };
    if (std::any_of(t.begin(), t.end(), is_joined)) touched.push_back(f);
  }
  return touched;
}

/// Makes the joins that the rules allow, and forgets the others.
JoinedMesh make_joins(WeldStage& stage, std::vector<WeldJoin>& joins) {
  WeldClasses classes(stage.rules);
  const auto is_impossible = [&](const WeldJoin& join) {
    const std::string_view reason =
        classes.join(stage.edges[join.first], stage.edges[join.second], join.run);
    if (reason.empty()) return false;
    refuse(stage, join, reason);
    return true;
  };
  joins.erase(std::remove_if(joins.begin(), joins.end(), is_impossible), joins.end());
  return {.staying = classes.staying_vertices(),
          .touched = find_touched(stage.rules.input.draft.soup, classes)};
}

/// The vertices, by those that stay, that must be joined together or not at all.
DisjointSets find_clusters(const WeldStage& stage, const JoinedMesh& joined,
                           std::span<const WeldJoin> joins) {
  const std::vector<Index>& staying = joined.staying;
  DisjointSets clusters(staying.size());
  for (const WeldJoin& join : joins) {
    const WeldEdge& edge = stage.edges[join.first];
    const WeldEdge& other = stage.edges[join.second];
    // The tip of a slit, which is one vertex already, does not tie it to others.
    if (edge.from == partner_of_from(other, join.run)) continue;
    if (edge.to == partner_of_to(other, join.run)) continue;
    clusters.unite(staying[edge.from], staying[edge.to]);
  }
  for (const Triangle& t : stage.rules.input.draft.soup.triangles) {
    Index first = kNoIndex;
    for (const Index v : t) {
      if (v == kNoIndex || staying[v] == v) continue;
      if (first != kNoIndex) clusters.unite(first, staying[v]);
      first = staying[v];
    }
  }
  return clusters;
}

/// Spreads harm to all that hangs together with what does it.
void spread(std::vector<WeldHarm>& harms, DisjointSets clusters) {
  for (Index v = 0; v < harms.size(); ++v) {
    if (harms[v] != WeldHarm::None) harms[clusters.find(v)] = harms[v];
  }
  for (Index v = 0; v < harms.size(); ++v) harms[v] = harms[clusters.find(v)];
}

/// Chooses joins that do no harm together.
class Settlement {
 public:
  explicit Settlement(WeldStage& stage) : stage_(stage) {}

  /// Of joins that do harm together those of edges that are nearest each other stay.
  ///
  /// @param joins  Those that stay are left.
  [[nodiscard]] JoinedMesh settle(std::vector<WeldJoin>& joins) {
    JoinedMesh joined = make_joins(stage_, joins);
    if (harms_of(joined).empty()) return joined;
    std::stable_sort(joins.begin(), joins.end(),
                     [](const WeldJoin& a, const WeldJoin& b) { return a.distance < b.distance; });
    std::vector<WeldJoin> waiting = std::exchange(joins, {});
    for (std::size_t step = 1; !waiting.empty(); ++step) {
      const auto end = step < kMaxJoinSteps ? end_of_step(waiting) : waiting.end();
      const std::size_t n_settled = joins.size();
      joins.insert(joins.end(), waiting.begin(), end);
      waiting.erase(waiting.begin(), end);
      joined = settle_behind(n_settled, joins);
    }
    return joined;
  }

 private:
  using Joins = std::vector<WeldJoin>;

  /// The first that is much farther than the first of all.
  [[nodiscard]] static Joins::iterator end_of_step(Joins& joins) {
    const double farthest = kJoinStep * joins.front().distance;
    return std::find_if(joins.begin(), joins.end(),
                        [&](const WeldJoin& join) { return join.distance > farthest; });
  }

  [[nodiscard]] std::vector<WeldHarm> harms_of(const JoinedMesh& joined) const {
    return find_weld_harms(stage_.rules.input.draft.soup, joined.staying, joined.touched);
  }

  /// Drops joins behind the first ones, which do no harm by themselves, until none is done.
  ///
  /// Whatever does harm has a vertex of those behind; should none be found they all go.
  [[nodiscard]] JoinedMesh settle_behind(std::size_t n_settled, Joins& joins) {
    for (std::size_t trial = 1;; ++trial) {
      JoinedMesh joined = make_joins(stage_, joins);
      std::vector<WeldHarm> harms = harms_of(joined);
      if (harms.empty() || joins.size() <= n_settled) return joined;
      std::vector<double> farthest(joined.staying.size(), 0.0);
      if (trial < kMaxJoinTrials) {
        farthest = farthest_joins(joined, std::span(joins).subspan(n_settled));
      } else {
        spread(harms, find_clusters(stage_, joined, joins));
      }
      const auto does_harm = [&](const WeldJoin& join) {
        return drop(join, joined, harms, farthest);
      };
      const auto first = joins.begin() + static_cast<std::ptrdiff_t>(n_settled);
      const auto kept = std::remove_if(first, joins.end(), does_harm);
      joins.erase(kept == joins.end() ? first : kept, joins.end());
    }
  }

  /// #V: by the vertex that stays, the largest distance of the joins of those it stays for.
  [[nodiscard]] std::vector<double> farthest_joins(const JoinedMesh& joined,
                                                   std::span<const WeldJoin> joins) const {
    std::vector<double> farthest(joined.staying.size(), 0.0);
    for (const WeldJoin& join : joins) {
      for (const Index v : ends_of(join, joined)) {
        farthest[v] = std::max(farthest[v], join.distance);
      }
    }
    return farthest;
  }

  /// The vertices that stay of the ends of a join.
  [[nodiscard]] std::array<Index, 2> ends_of(const WeldJoin& join, const JoinedMesh& joined) const {
    const WeldEdge& edge = stage_.edges[join.first];
    return {joined.staying[edge.from], joined.staying[edge.to]};
  }

  /// Refuses a join of vertices that do harm, where it is the farthest of one of them. Two faces
  /// that become one have no sides that should be joined.
  [[nodiscard]] bool drop(const WeldJoin& join, const JoinedMesh& joined,
                          std::span<const WeldHarm> harms, std::span<const double> farthest) {
    for (const Index v : ends_of(join, joined)) {
      if (harms[v] == WeldHarm::None) continue;
      if (harms[v] != WeldHarm::Duplicate && join.distance < farthest[v]) continue;
      refuse(stage_, join, reason_of(harms[v]));
      return true;
    }
    return false;
  }

  WeldStage& stage_;
};

/// Numbers the operations in order of the lowest vertex of each, and writes them down.
void write_edits(const Soup& soup, std::span<const Index> staying, DisjointSets& clusters,
                 Edits& edits) {
  std::vector<Index> op_of_cluster(staying.size(), kNoIndex);
  for (Index v = 0; v < staying.size(); ++v) {
    if (staying[v] == v) continue;
    Index& op = op_of_cluster[clusters.find(staying[v])];
    if (op == kNoIndex) op = edits.begin_operation();
  }
  for (Index f = 0; f < soup.n_faces(); ++f) {
    Triangle t = soup.triangles[f];
    Index op = kNoIndex;
    for (Index& v : t) {
      if (v == kNoIndex || staying[v] == v) continue;
      v = staying[v];
      op = op_of_cluster[clusters.find(v)];
    }
    if (op != kNoIndex) edits.changed_faces.push_back({op, f, t});
  }
}

/// Keeps other operations off a face.
void occupy(WeldStage& stage, Index face) {
  for (const Index v : stage.rules.input.draft.soup.triangles[face]) {
    if (v != kNoIndex) stage.is_busy[v] = 1;
  }
}

}  // namespace

void refuse(WeldStage& stage, const WeldJoin& join, std::string_view reason) {
  const WeldEdge& a = stage.edges[join.first];
  const WeldEdge& b = stage.edges[join.second];
  stage.result.refused.push_back({.code = DefectCode::Slit,
                                  .vertex = std::min({a.from, a.to, b.from, b.to}),
                                  .face = std::min(a.face, b.face),
                                  .reason = std::string(reason)});
}

void add_weld_operations(WeldStage& stage, std::vector<WeldJoin> joins) {
  if (joins.empty()) return;
  const Soup& soup = stage.rules.input.draft.soup;
  const JoinedMesh joined = Settlement(stage).settle(joins);
  DisjointSets clusters = find_clusters(stage, joined, joins);
  const std::size_t n_changed_before = stage.result.edits.changed_faces.size();
  write_edits(soup, joined.staying, clusters, stage.result.edits);
  for (const Index f : joined.touched) occupy(stage, f);
  // Faces that are not in the complex may change too.
  const auto changed = std::span(stage.result.edits.changed_faces).subspan(n_changed_before);
  for (const Edits::ChangedFace& face : changed) occupy(stage, face.face);
}

}  // namespace meshalyzer
