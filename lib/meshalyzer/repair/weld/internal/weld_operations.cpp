#include "meshalyzer/repair/weld/internal/weld_operations.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/repair/rules/internal/merge_rule.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

/// Rejected joins over the largest distances are dropped first. After this number of trials the
/// whole cluster of a rejected join is dropped, so that the search ends.
constexpr std::size_t kMaxJoinTrials = 8;
/// If joins are rejected together, they are added in steps: each step adds joins up to this
/// multiple of the smallest distance, and the last one adds all remaining joins.
constexpr double kJoinStep = 8.0;
constexpr std::size_t kMaxJoinSteps = 6;

/// The merges that joins would make.
struct JoinedMesh {
  /// For each vertex, the one that represents all those that it is joined with.
  std::vector<Index> representative;
  /// Faces of the complex with a joined vertex, ascending.
  std::vector<Index> affected;
};

std::vector<Index> find_affected_faces(const Soup& soup, const WeldClasses& classes) {
  std::vector<Index> affected;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const Triangle& t = soup.triangles[f];
    if (!is_in_complex(t)) continue;
    const auto is_joined = [&](Index v) { return !classes.is_alone(v); };
    if (std::any_of(t.begin(), t.end(), is_joined)) affected.push_back(f);
  }
  return affected;
}

/// Makes the joins that the rules permit, and drops the others.
JoinedMesh make_joins(WeldState& state, std::vector<WeldJoin>& joins) {
  WeldClasses classes(state.rules);
  const auto is_impossible = [&](const WeldJoin& join) {
    const std::string_view reason =
        classes.join(state.edges[join.first], state.edges[join.second], join.run);
    if (reason.empty()) return false;
    refuse(state, join, reason);
    return true;
  };
  joins.erase(std::remove_if(joins.begin(), joins.end(), is_impossible), joins.end());
  return {.representative = classes.representatives(),
          .affected = find_affected_faces(state.rules.input.tracked.soup, classes)};
}

/// Returns the vertices, by their representatives, that must be joined together or not at all.
DisjointSets find_clusters(const WeldState& state, const JoinedMesh& joined,
                           std::span<const WeldJoin> joins) {
  const std::vector<Index>& representative = joined.representative;
  DisjointSets clusters(representative.size());
  for (const WeldJoin& join : joins) {
    const WeldEdge& edge = state.edges[join.first];
    const WeldEdge& other = state.edges[join.second];
    // The tip of a slit, which is already one vertex, does not connect it to others.
    if (edge.from == partner_of_from(other, join.run)) continue;
    if (edge.to == partner_of_to(other, join.run)) continue;
    clusters.unite(representative[edge.from], representative[edge.to]);
  }
  for (const Triangle& t : state.rules.input.tracked.soup.triangles) {
    Index first = kNoIndex;
    for (const Index v : t) {
      if (v == kNoIndex || representative[v] == v) continue;
      if (first != kNoIndex) clusters.unite(first, representative[v]);
      first = representative[v];
    }
  }
  return clusters;
}

/// Spreads each rejection to its whole cluster.
void spread(std::vector<MergeRejection>& rejections, DisjointSets clusters) {
  for (Index v = 0; v < rejections.size(); ++v) {
    if (rejections[v] != MergeRejection::None) rejections[clusters.find(v)] = rejections[v];
  }
  for (Index v = 0; v < rejections.size(); ++v) rejections[v] = rejections[clusters.find(v)];
}

/// Selects joins that are accepted together.
class JoinSelection {
 public:
  explicit JoinSelection(WeldState& state) : state_(state) {}

  /// If joins are rejected together, keeps those over the smallest distances.
  ///
  /// @param joins  Receives the joins that are kept.
  [[nodiscard]] JoinedMesh select(std::vector<WeldJoin>& joins) {
    JoinedMesh joined = make_joins(state_, joins);
    if (rejections_of(joined).empty()) return joined;
    std::stable_sort(joins.begin(), joins.end(),
                     [](const WeldJoin& a, const WeldJoin& b) { return a.distance < b.distance; });
    std::vector<WeldJoin> waiting = std::exchange(joins, {});
    for (std::size_t step = 1; !waiting.empty(); ++step) {
      const auto end = step < kMaxJoinSteps ? end_of_step(waiting) : waiting.end();
      const std::size_t n_selected = joins.size();
      joins.insert(joins.end(), waiting.begin(), end);
      waiting.erase(waiting.begin(), end);
      joined = select_behind(n_selected, joins);
    }
    return joined;
  }

 private:
  using Joins = std::vector<WeldJoin>;

  /// Returns the first join over a much larger distance than the first of all.
  [[nodiscard]] static Joins::iterator end_of_step(Joins& joins) {
    const double farthest = kJoinStep * joins.front().distance;
    return std::find_if(joins.begin(), joins.end(),
                        [&](const WeldJoin& join) { return join.distance > farthest; });
  }

  [[nodiscard]] std::vector<MergeRejection> rejections_of(const JoinedMesh& joined) const {
    return check_merges(state_.rules.input.tracked.soup, joined.representative, joined.affected);
  }

  /// Drops joins after the first n_selected, which are accepted by themselves, until nothing is
  /// rejected.
  ///
  /// Each rejected vertex belongs to one of the later joins; if none of them is found, all of them
  /// are dropped.
  [[nodiscard]] JoinedMesh select_behind(std::size_t n_selected, Joins& joins) {
    for (std::size_t trial = 1;; ++trial) {
      JoinedMesh joined = make_joins(state_, joins);
      std::vector<MergeRejection> rejections = rejections_of(joined);
      if (rejections.empty() || joins.size() <= n_selected) return joined;
      std::vector<double> farthest(joined.representative.size(), 0.0);
      if (trial < kMaxJoinTrials) {
        farthest = farthest_joins(joined, std::span(joins).subspan(n_selected));
      } else {
        spread(rejections, find_clusters(state_, joined, joins));
      }
      const auto is_rejected = [&](const WeldJoin& join) {
        return drop(join, joined, rejections, farthest);
      };
      const auto first = joins.begin() + static_cast<std::ptrdiff_t>(n_selected);
      const auto kept = std::remove_if(first, joins.end(), is_rejected);
      joins.erase(kept == joins.end() ? first : kept, joins.end());
    }
  }

  /// #V: by representative, the largest distance of the joins that it represents.
  [[nodiscard]] std::vector<double> farthest_joins(const JoinedMesh& joined,
                                                   std::span<const WeldJoin> joins) const {
    std::vector<double> farthest(joined.representative.size(), 0.0);
    for (const WeldJoin& join : joins) {
      for (const Index v : ends_of(join, joined)) {
        farthest[v] = std::max(farthest[v], join.distance);
      }
    }
    return farthest;
  }

  /// Returns the representatives of the ends of a join.
  [[nodiscard]] std::array<Index, 2> ends_of(const WeldJoin& join, const JoinedMesh& joined) const {
    const WeldEdge& edge = state_.edges[join.first];
    return {joined.representative[edge.from], joined.representative[edge.to]};
  }

  /// Refuses a join with a rejected vertex if it is the one over the largest distance there. Two
  /// faces that become one have no sides that should be joined.
  [[nodiscard]] bool drop(const WeldJoin& join, const JoinedMesh& joined,
                          std::span<const MergeRejection> rejections,
                          std::span<const double> farthest) {
    for (const Index v : ends_of(join, joined)) {
      if (rejections[v] == MergeRejection::None) continue;
      if (rejections[v] != MergeRejection::Duplicate && join.distance < farthest[v]) continue;
      refuse(state_, join, reason_of(rejections[v]));
      return true;
    }
    return false;
  }

  WeldState& state_;
};

/// Numbers the operations in order of the lowest vertex of each, and writes their edits.
void write_edits(const Soup& soup, std::span<const Index> representative, DisjointSets& clusters,
                 Edits& edits) {
  std::vector<Index> op_of_cluster(representative.size(), kNoIndex);
  for (Index v = 0; v < representative.size(); ++v) {
    if (representative[v] == v) continue;
    Index& op = op_of_cluster[clusters.find(representative[v])];
    if (op == kNoIndex) op = edits.begin_operation();
  }
  for (Index f = 0; f < soup.n_faces(); ++f) {
    Triangle t = soup.triangles[f];
    Index op = kNoIndex;
    for (Index& v : t) {
      if (v == kNoIndex || representative[v] == v) continue;
      v = representative[v];
      op = op_of_cluster[clusters.find(v)];
    }
    if (op != kNoIndex) edits.changed_faces.push_back({op, f, t});
  }
}

/// Keeps other operations off a face.
void occupy(WeldState& state, Index face) {
  for (const Index v : state.rules.input.tracked.soup.triangles[face]) {
    if (v != kNoIndex) state.is_busy[v] = 1;
  }
}

}  // namespace

void refuse(WeldState& state, const WeldJoin& join, std::string_view reason) {
  const WeldEdge& a = state.edges[join.first];
  const WeldEdge& b = state.edges[join.second];
  state.result.refused.push_back({.code = DefectCode::Slit,
                                  .vertex = std::min({a.from, a.to, b.from, b.to}),
                                  .face = std::min(a.face, b.face),
                                  .reason = std::string(reason)});
}

void add_weld_operations(WeldState& state, std::vector<WeldJoin> joins) {
  if (joins.empty()) return;
  const Soup& soup = state.rules.input.tracked.soup;
  const JoinedMesh joined = JoinSelection(state).select(joins);
  DisjointSets clusters = find_clusters(state, joined, joins);
  const std::size_t n_changed_before = state.result.edits.changed_faces.size();
  write_edits(soup, joined.representative, clusters, state.result.edits);
  for (const Index f : joined.affected) occupy(state, f);
  // Faces that are not in the complex may change too.
  const auto changed = std::span(state.result.edits.changed_faces).subspan(n_changed_before);
  for (const Edits::ChangedFace& face : changed) occupy(state, face.face);
}

}  // namespace meshalyzer
