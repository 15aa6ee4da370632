#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/base/runs.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/weld/internal/weld_candidates.h"
#include "meshalyzer/repair/weld/internal/weld_chains.h"
#include "meshalyzer/repair/weld/internal/weld_edges.h"
#include "meshalyzer/repair/weld/internal/weld_lengths.h"
#include "meshalyzer/repair/weld/internal/weld_matching.h"
#include "meshalyzer/repair/weld/internal/weld_operations.h"
#include "meshalyzer/repair/weld/internal/weld_pairing.h"
#include "meshalyzer/repair/weld/internal/weld_splits.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// If joins within a length are rejected, others may still be possible within this share of it.
constexpr double kShorter = 0.5;

/// Calls `visit` for each set of several edges at one place, ascending by edge.
template <typename Visit>
void for_each_coincident(std::span<const WeldEdge> edges, std::span<const Index> places,
                         Visit&& visit) {
  const auto upper = [&](Index e) { return std::max(places[edges[e].from], places[edges[e].to]); };
  const ItemsByGroup by_lower(places.size(), [&](const auto& use) {
    for (Index e = 0; e < edges.size(); ++e) {
      use(std::min(places[edges[e].from], places[edges[e].to]), e);
    }
  });
  std::vector<Index> sorted;
  for (std::size_t place = 0; place < by_lower.size(); ++place) {
    sorted.assign(by_lower[place].begin(), by_lower[place].end());
    std::sort(sorted.begin(), sorted.end(),
              [&](Index a, Index b) { return std::pair(upper(a), a) < std::pair(upper(b), b); });
    for_each_run(std::span<const Index>(sorted), upper, [&](std::span<const Index> group) {
      if (group.size() > 1) visit(group);
    });
  }
}

/// Joins edges at exactly the same place.
///
/// @return #edges: non-zero for each that is finished, by being joined or refused.
std::vector<std::uint8_t> zip_coincident(WeldState& state, std::span<const Index> places) {
  std::vector<std::uint8_t> is_done(state.edges.size(), 0);
  std::vector<WeldJoin> joins;
  std::vector<EdgeAtPlace> at_place;
  for_each_coincident(state.edges, places, [&](std::span<const Index> group) {
    at_place.clear();
    for (const Index e : group) {
      is_done[e] = 1;
      const bool is_along = places[state.edges[e].from] == places[state.edges[group[0]].from];
      at_place.push_back({e, is_along ? EdgeRun::Same : EdgeRun::Opposite});
    }
    const Pairing pairing =
        pair_edges_at_place(state.rules.input.tracked.soup, state.edges, at_place, 0.0);
    if (!pairing.refusal.empty()) {
      refuse(state, {.first = group[0], .second = group[1]}, pairing.refusal);
    }
    joins.insert(joins.end(), pairing.joins.begin(), pairing.joins.end());
  });
  add_weld_operations(state, std::move(joins));
  return is_done;
}

/// Returns the numbers of the edges that are neither finished nor next to another operation.
std::vector<Index> free_edges(const WeldState& state, std::span<const std::uint8_t> is_done) {
  std::vector<Index> wanted;
  for (std::size_t e = 0; e < state.edges.size(); ++e) {
    const WeldEdge& edge = state.edges[e];
    if (is_done[e] != 0 || state.is_busy[edge.from] != 0 || state.is_busy[edge.to] != 0) continue;
    wanted.push_back(static_cast<Index>(e));
  }
  return wanted;
}

/// Returns the ends of some edges, by place, each once, ascending.
std::vector<Index> used_places(const ItemsByGroup& at_places) {
  std::vector<Index> used;
  for (Index v = 0; v < at_places.size(); ++v) {
    if (!at_places[v].empty()) used.push_back(v);
  }
  return used;
}

/// Joins edges that are near each other.
void zip_near(WeldState& state, std::span<const Index> wanted) {
  const WeldCandidates candidates = find_weld_candidates(state.rules.input.tracked.soup.positions,
                                                         state.edges, wanted, state.rules.reach);
  add_weld_operations(state, match_candidates(state, candidates));
}

/// Closes cracks with T-junctions.
///
/// @param present  The edges that could have been joined at first.
/// @param wanted   Those of them that are not joined yet.
void close_junctions(WeldState& state, std::span<const Index> places,
                     std::span<const Index> present, std::span<const Index> wanted) {
  if (wanted.empty()) return;
  const std::vector<Vec3>& positions = state.rules.input.tracked.soup.positions;
  const ItemsByGroup at_places = list_edges_at_places(state.edges, present, places);
  const NearPoints near(positions, used_places(at_places), state.rules.reach);
  const NearEdges edges{.positions = positions,
                        .edges = state.edges,
                        .places = places,
                        .at_places = at_places,
                        .near = near};
  std::vector<WeldCrack> cracks;
  for (const WeldChain& chain : find_weld_chains(edges, wanted)) {
    cracks.push_back(crack_along(state.edges, chain));
  }
  add_split_operations(state, cracks);
  add_split_operations(state, find_interleaved_cracks(edges, wanted));
}

/// Welds these edges within PassInput::length.
PassResult weld(const PassInput& input, std::span<const WeldEdge> edges) {
  if (edges.empty()) return {};
  const Soup& soup = input.tracked.soup;
  const std::vector<Index> places = find_weld_places(soup.positions, edges);
  const std::vector<Index> faces_at_vertices = count_faces_at_vertices(soup);
  const bool is_smallest = input.operation_size == OperationSize::Smallest;
  const WeldRules rules{.input = input,
                        .faces_at_vertices = faces_at_vertices,
                        .reach = is_smallest ? kShorter * input.length : input.length};
  WeldState state{.rules = rules,
                  .edges = edges,
                  .is_busy = std::vector<std::uint8_t>(soup.n_vertices(), 0),
                  .result = {}};
  const std::vector<std::uint8_t> is_done = zip_coincident(state, places);
  if (rules.reach > 0.0 && !input.wants_to_stop()) {
    const std::vector<Index> present = free_edges(state, is_done);
    zip_near(state, present);
    if (!input.wants_to_stop()) close_junctions(state, places, present, free_edges(state, is_done));
  }
  state.result.has_smaller_operations = rules.reach > 0.0;
  return std::move(state.result);
}

/// Returns the largest distance over which borders are joined.
double limit_of(const PassInput& input, double within) {
  return std::min(within, input.limits.max_deviation);
}

WeldSteps steps_of(const PassInput& input) {
  return {input.tolerances.degeneracy, input.original.n_faces()};
}

/// Returns the numbers of the edges with one of these vertices, given by key, ascending.
std::vector<Index> edges_at(std::span<const WeldEdge> edges, const TrackedMesh& tracked,
                            std::span<const Index> vertex_keys) {
  const auto is_among = [&](Index v) {
    return std::binary_search(vertex_keys.begin(), vertex_keys.end(), tracked.vertex_keys[v]);
  };
  std::vector<Index> found;
  for (Index e = 0; e < edges.size(); ++e) {
    if (is_among(edges[e].from) || is_among(edges[e].to)) found.push_back(e);
  }
  return found;
}

}  // namespace

PassResult weld_borders(const PassInput& input, double within) {
  const std::vector<WeldEdge> edges = find_weld_edges(input.mesh);
  const double limit = limit_of(input, within);
  if (input.length <= limit) return weld(input, edges);
  const WeldDistances distances(input.tracked.soup.positions, edges);
  std::vector<WeldEdge> unaffected;
  for (const Index e : distances.edges_without_distance(limit, input.length)) {
    unaffected.push_back(edges[e]);
  }
  return weld(input, unaffected);
}

std::optional<double> next_weld_length(const PassInput& input, double within,
                                       std::span<const Index> changed) {
  const double limit = limit_of(input, within);
  if (changed.empty() && input.length >= limit) return std::nullopt;
  const std::vector<WeldEdge> edges = find_weld_edges(input.mesh);
  if (edges.empty()) return std::nullopt;
  const WeldDistances distances(input.tracked.soup.positions, edges);
  const WeldSteps steps = steps_of(input);
  const std::vector<Index> changed_edges = edges_at(edges, input.tracked, changed);
  const std::optional<double> earlier = distances.first_step(changed_edges, steps, input.length);
  if (earlier && *earlier < input.length) return earlier;
  if (input.length >= limit) return std::nullopt;
  return distances.next_step(steps, input.length, limit);
}

}  // namespace meshalyzer
