#include "meshalyzer/repair/weld/internal/weld_matching.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/repair/weld/internal/weld_pairing.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <numeric>
#include <queue>
#include <string_view>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

/// Edges isolated by this multiple of their own distance belong together, whatever else is near.
constexpr double kIsolation = 8.0;

/// Groups candidates by the edges that they connect with each other.
///
/// @param chosen  The candidates to group, ascending.
/// @return The groups by their lowest edges; those of other edges are empty.
ItemsByGroup group_connected(std::span<const WeldJoin> candidates, std::span<const Index> chosen,
                             std::size_t n_edges) {
  DisjointSets sets(n_edges);
  for (const Index c : chosen) sets.unite(candidates[c].first, candidates[c].second);
  return ItemsByGroup(n_edges, [&](const auto& use) {
    for (const Index c : chosen) use(sets.find(candidates[c].first), c);
  });
}

class Matching {
 public:
  Matching(WeldState& state, const WeldCandidates& candidates)
      : state_(state),
        candidates_(candidates.joins),
        reach_(candidates.reach),
        classes_(state.rules),
        is_taken_(state.edges.size(), 0) {}

  [[nodiscard]] std::vector<WeldJoin> run() {
    std::vector<Index> all(candidates_.size());
    std::iota(all.begin(), all.end(), Index{0});
    pair_up_clear(all);
    pair_up_isolated();
    refuse_unclear();
    zip(still_free(crowded_));
    return std::move(joins_);
  }

 private:
  /// Pairs the groups whose edges are all near each other; the others are crowded.
  void pair_up_clear(std::span<const Index> candidates) {
    const ItemsByGroup groups = group_connected(candidates_, candidates, state_.edges.size());
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const std::span<const Index> group = groups[i];
      if (group.empty()) continue;
      if (!are_all_near(group)) {
        crowded_.insert(crowded_.end(), group.begin(), group.end());
        continue;
      }
      const Pairing pairing = pairing_of(group, reach_);
      for (const WeldJoin& join : pairing.joins) {
        if (const auto reason = try_join(join); !reason.empty()) refuse(state_, join, reason);
      }
      if (pairing.joins.empty()) {
        unclear_.push_back({{group.begin(), group.end()}, pairing.refusal});
      } else if (!pairing.refusal.empty()) {
        refuse(state_, candidates_[group[0]], pairing.refusal);
      }
    }
  }

  /// If the reach is so long that one edge is near many: pairs edges that are near each other and
  /// near no others within a multiple of their distance.
  void pair_up_isolated() {
    std::vector<Index> rest = crowded_;
    for (const Unclear& group : unclear_) {
      if (group.candidates.size() > 1) {
        rest.insert(rest.end(), group.candidates.begin(), group.candidates.end());
      }
    }
    std::sort(rest.begin(), rest.end());
    for (double longest = reach_ / kIsolation; longest > 0.0;) {
      rest = still_free(rest);
      std::erase_if(rest, [&](Index c) { return candidates_[c].distance > longest; });
      if (rest.empty()) return;
      const ItemsByGroup groups = group_connected(candidates_, rest, state_.edges.size());
      for (std::size_t i = 0; i < groups.size(); ++i) {
        if (!groups[i].empty()) pair_up_if_isolated(groups[i], longest);
      }
      // The groups stay the same down to the distance of the farthest pair.
      longest = std::min(longest, farthest_of(rest)) / kIsolation;
    }
  }

  /// @param longest  A length within which there is no edge of another group.
  void pair_up_if_isolated(std::span<const Index> group, double longest) {
    const double distance = farthest_of(group);
    if (distance * kIsolation > longest || !are_all_near(group)) return;
    for (const WeldJoin& join : pairing_of(group, distance).joins) {
      static_cast<void>(try_join(join));
    }
  }

  void refuse_unclear() {
    for (const Unclear& group : unclear_) {
      const std::vector<Index> left = still_free(group.candidates);
      if (!left.empty()) refuse(state_, candidates_[left[0]], group.refusal);
    }
  }

  [[nodiscard]] double farthest_of(std::span<const Index> candidates) const {
    double farthest = 0.0;
    for (const Index c : candidates) farthest = std::max(farthest, candidates_[c].distance);
    return farthest;
  }

  /// Tells whether neither edge of a candidate is joined yet.
  [[nodiscard]] bool is_free(Index candidate) const {
    const WeldJoin& join = candidates_[candidate];
    return is_taken_[join.first] == 0 && is_taken_[join.second] == 0;
  }

  /// Returns those that may still be joined, in the same order.
  [[nodiscard]] std::vector<Index> still_free(std::span<const Index> candidates) const {
    std::vector<Index> found;
    std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(found),
                 [&](Index c) { return is_free(c); });
    return found;
  }

  /// Returns the number of candidates of a group's lowest edge, which are its first ones.
  [[nodiscard]] std::size_t n_of_lowest(std::span<const Index> group) const {
    const Index lowest = candidates_[group[0]].first;
    std::size_t n = 0;
    while (n < group.size() && candidates_[group[n]].first == lowest) ++n;
    return n;
  }

  /// Tells whether each edge of a group is near each other one of it.
  [[nodiscard]] bool are_all_near(std::span<const Index> group) const {
    const std::size_t n = n_of_lowest(group);
    return group.size() == (n + 1) * n / 2;
  }

  /// Pairs the edges of a group whose edges are all near each other.
  [[nodiscard]] Pairing pairing_of(std::span<const Index> group, double reach) const {
    std::vector<EdgeAtPlace> at_place{{candidates_[group[0]].first, EdgeRun::Same}};
    for (const Index c : group.first(n_of_lowest(group))) {
      at_place.push_back({candidates_[c].second, candidates_[c].run});
    }
    Pairing pairing =
        pair_edges_at_place(state_.rules.input.tracked.soup, state_.edges, at_place, reach);
    for (WeldJoin& join : pairing.joins) join.distance = farthest_of(group);
    return pairing;
  }

  /// @return The reason as WeldClasses::join() returns it.
  std::string_view try_join(const WeldJoin& join) {
    const std::string_view reason =
        classes_.join(state_.edges[join.first], state_.edges[join.second], join.run);
    if (!reason.empty()) return reason;
    is_taken_[join.first] = is_taken_[join.second] = 1;
    joins_.push_back(join);
    return {};
  }

  /// A candidate in the present state; the best one is the least.
  struct Offer {
    EdgeRun run = EdgeRun::Opposite;
    /// The number of the two pairs of ends that are not joined yet: a slit closes from its tips.
    std::uint8_t n_apart = 0;
    double distance = 0.0;
    Index candidate = 0;

    [[nodiscard]] auto key() const { return std::tie(run, n_apart, distance, candidate); }
    friend bool operator>(const Offer& a, const Offer& b) { return a.key() > b.key(); }
  };

  /// Repeatedly takes the best offer; offers next to joined edges improve.
  void zip(std::span<const Index> rest) {
    list_by_ends(rest);
    std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers;
    for (const Index c : rest) offers.push(offer(c));
    while (!offers.empty()) {
      const Index best = offers.top().candidate;
      offers.pop();
      if (!is_free(best)) continue;
      const WeldJoin& join = candidates_[best];
      if (classes_.are_joined(state_.edges[join.first].third, state_.edges[join.second].third)) {
        continue;
      }
      const std::vector<Index> ends = separate_ends(join);
      if (!try_join(join).empty()) continue;
      for (const Index v : ends) {
        for (const Index c : at_end(v)) offers.push(offer(c));
      }
    }
  }

  /// Returns the ends of two edges that are not joined yet, in pairs.
  [[nodiscard]] std::vector<Index> separate_ends(const WeldJoin& join) {
    const WeldEdge& a = state_.edges[join.first];
    const WeldEdge& b = state_.edges[join.second];
    std::vector<Index> ends;
    for (const auto& [v, w] : {std::pair(a.from, partner_of_from(b, join.run)),
                               std::pair(a.to, partner_of_to(b, join.run))}) {
      if (!classes_.are_joined(v, w)) ends.insert(ends.end(), {v, w});
    }
    return ends;
  }

  /// Lists candidates by the ends of their first edges.
  void list_by_ends(std::span<const Index> rest) {
    for (const Index c : rest) {
      const WeldEdge& edge = state_.edges[candidates_[c].first];
      for (const Index v : {edge.from, edge.to}) by_ends_.push_back({v, c});
    }
    std::sort(by_ends_.begin(), by_ends_.end());
  }

  /// Returns those of an end that may still be joined.
  [[nodiscard]] std::vector<Index> at_end(Index vertex) const {
    std::vector<Index> found;
    auto entry = std::lower_bound(by_ends_.begin(), by_ends_.end(), std::pair(vertex, Index{0}));
    for (; entry != by_ends_.end() && entry->first == vertex; ++entry) {
      if (is_free(entry->second)) found.push_back(entry->second);
    }
    return found;
  }

  [[nodiscard]] Offer offer(Index c) {
    const auto n_apart = separate_ends(candidates_[c]).size() / 2;
    return {.run = candidates_[c].run,
            .n_apart = static_cast<std::uint8_t>(n_apart),
            .distance = candidates_[c].distance,
            .candidate = c};
  }

  /// A group that could not be paired though all of its edges are near each other.
  struct Unclear {
    std::vector<Index> candidates;
    std::string_view refusal;
  };

  WeldState& state_;
  std::span<const WeldJoin> candidates_;
  double reach_;
  WeldClasses classes_;
  std::vector<std::uint8_t> is_taken_;
  std::vector<WeldJoin> joins_;
  /// Candidates of groups not all of whose edges are near each other.
  std::vector<Index> crowded_;
  std::vector<Unclear> unclear_;
  /// Vertex and candidate, sorted.
  std::vector<std::pair<Index, Index>> by_ends_;
};

}  // namespace

std::vector<WeldJoin> match_candidates(WeldState& state, const WeldCandidates& candidates) {
  if (candidates.joins.empty()) return {};
  return Matching(state, candidates).run();
}

}  // namespace meshalyzer
