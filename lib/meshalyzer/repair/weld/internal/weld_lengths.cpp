#include "meshalyzer/repair/weld/internal/weld_lengths.h"

#include "meshalyzer/base/box.h"
#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/spatial/triangle_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

namespace meshalyzer {
namespace {

constexpr double kNoDistance = std::numeric_limits<double>::infinity();
/// The number of pairs of near edges that is always looked at, and the number that is added for
/// each edge.
constexpr std::size_t kFewNearEdges = 1'000'000;
constexpr std::size_t kNearEdgesPerEdge = 64;
/// The share of the limit within which distances are searched first.
constexpr double kShareSearchedFirst = 1e-16;

std::vector<Box3> boxes_of(std::span<const Vec3> positions, std::span<const WeldEdge> edges) {
  std::vector<Box3> boxes(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    boxes[e].extend(positions[edges[e].from]);
    boxes[e].extend(positions[edges[e].to]);
  }
  return boxes;
}

/// 2^(-3/4), 2^(-1/2), 2^(-1/4), 1.
constexpr std::array kFourSteps{0.5946035575013605, 0.7071067811865476, 0.8408964152537145, 1.0};
constexpr std::array kTwoSteps{0.7071067811865476, 1.0};
constexpr std::array kOneStep{1.0};

/// The largest numbers of faces of a mesh for which there are four and two steps.
constexpr std::size_t kFacesForFourSteps = 2'048;
constexpr std::size_t kFacesForTwoSteps = 8'192;

std::span<const double> steps_for(std::size_t n_faces) {
  if (n_faces <= kFacesForFourSteps) return kFourSteps;
  if (n_faces <= kFacesForTwoSteps) return kTwoSteps;
  return kOneStep;
}

}  // namespace

WeldSteps::WeldSteps(double shortest, std::size_t n_faces)
    : shortest_(shortest), ends_(steps_for(n_faces)) {}

double WeldSteps::end_of(double distance) const {
  if (distance <= shortest_) return shortest_;
  int exponent = 0;
  const double fraction = std::frexp(distance, &exponent);
  if (fraction == 0.5) return distance;
  return std::ldexp(*std::lower_bound(ends_.begin(), ends_.end(), fraction), exponent);
}

WeldDistances::WeldDistances(std::span<const Vec3> positions, std::span<const WeldEdge> edges)
    : positions_(positions), edges_(edges), boxes_(boxes_of(positions, edges)), tree_(boxes_) {}

/// Calls `visit` for the pairs of one of these edges and another one whose boxes are within a
/// distance, until it returns false.
WeldDistances::Visited WeldDistances::visit_pairs(std::span<const Index> of, double within,
                                                  const VisitPair& visit) const {
  const std::size_t most = kFewNearEdges + kNearEdgesPerEdge * of.size();
  std::size_t n_near = 0;
  for (const Index a : of) {
    // The thousandth is a margin for rounding.
    const std::vector<Index> found = tree_.meeting(grown(boxes_[a], 1.001 * within));
    n_near += found.size();
    if (n_near > most) return Visited::TooMany;
    for (const Index b : found) {
      if (a != b && !visit(a, b)) return Visited::Some;
    }
  }
  return Visited::All;
}

std::optional<double> WeldDistances::first_step(std::span<const Index> of, const WeldSteps& steps,
                                                double limit) const {
  const PairDistance joining = std::bind_front(&WeldDistances::joining_distance, this);
  return step_of_least(of, joining, steps, {.known = 0.0, .limit = limit});
}

std::optional<double> WeldDistances::next_step(const WeldSteps& steps, double length,
                                               double limit) const {
  const std::vector<Index> all = all_edges();
  const PairDistance joining = std::bind_front(&WeldDistances::joining_distance, this);
  const PairDistance any = [&](Index a, Index b, double) { return least_above(a, b, length); };
  const double next = steps.end_of(std::nextafter(length, kNoDistance));
  const Range behind{.known = next, .limit = limit};
  if (!is_any_within(all, joining, next)) return step_of_least(all, joining, steps, behind);
  return is_any_within(all, any, next) ? next : step_of_least(all, any, steps, behind);
}

/// Tells whether a pair of one of these edges and another one has a distance up to a length; true
/// too if finding it takes long.
bool WeldDistances::is_any_within(std::span<const Index> of, const PairDistance& distance,
                                  double length) const {
  const double beyond = std::nextafter(length, kNoDistance);
  return visit_pairs(of, length, [&](Index a, Index b) {
           return !(distance(a, b, beyond) <= length);
         }) != Visited::All;
}

/// Returns the end of the step with the least distance of a pair, none of which is within the known
/// length; nothing if there is none up to the limit. If there are many near pairs, it may be an
/// earlier step.
std::optional<double> WeldDistances::step_of_least(std::span<const Index> of,
                                                   const PairDistance& distance,
                                                   const WeldSteps& steps, Range range) const {
  double growth = 2.0;
  for (double within = range.known; within < range.limit; growth *= growth) {
    within = std::min(range.limit, std::max(growth * within, kShareSearchedFirst * range.limit));
    double least = kNoDistance;
    const Visited visited = visit_pairs(of, within, [&](Index a, Index b) {
      least = std::min(least, distance(a, b, least));
      return true;
    });
    if (visited == Visited::TooMany) return steps.end_of(std::nextafter(range.known, kNoDistance));
    // Pairs farther than this are not all known yet.
    if (least <= within) return steps.end_of(least);
  }
  return std::nullopt;
}

/// Returns the least length within which two edges may be joined, or a crack along both may begin:
/// an end of one is near an end of the other, and one of the other ends is near the other edge.
///
/// @param below  No distance is returned if it is no less than this.
double WeldDistances::joining_distance(Index a, Index b, double below) const {
  const WeldEdge& e = edges_[a];
  const WeldEdge& f = edges_[b];
  if (e.face == f.face) return kNoDistance;
  double least = below;
  for (const auto& [v, other_v] : {std::pair(e.from, e.to), std::pair(e.to, e.from)}) {
    for (const auto& [w, other_w] : {std::pair(f.from, f.to), std::pair(f.to, f.from)}) {
      const Vec3 offset = positions_[v] - positions_[w];
      // No vector is shorter than one of its coordinates, which takes a part of the time.
      if (offset.cwiseAbs().maxCoeff() >= least) continue;
      const double of_ends = offset.stableNorm();
      if (of_ends >= least) continue;
      const double of_edges = std::min(from_edge(other_v, f), from_edge(other_w, e));
      least = std::min(least, std::max(of_ends, of_edges));
    }
  }
  return least < below ? least : kNoDistance;
}

double WeldDistances::from_edge(Index v, const WeldEdge& edge) const {
  return distance_from_segment(positions_[edge.from], positions_[edge.to], positions_[v]);
}

/// Returns the least of all distances between two edges that is above a length.
double WeldDistances::least_above(Index a, Index b, double length) const {
  double least = kNoDistance;
  const auto consider = [&](double distance) {
    if (distance > length) least = std::min(least, distance);
  };
  const auto consider_ends = [&](const WeldEdge& of, const WeldEdge& other) {
    for (const Index v : {of.from, of.to}) {
      consider((positions_[v] - positions_[other.from]).stableNorm());
      consider((positions_[v] - positions_[other.to]).stableNorm());
      consider(from_edge(v, other));
    }
  };
  consider_ends(edges_[a], edges_[b]);
  consider_ends(edges_[b], edges_[a]);
  return least;
}

std::vector<Index> WeldDistances::all_edges() const {
  std::vector<Index> all(edges_.size());
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

std::vector<Index> WeldDistances::edges_without_distance(double limit, double length) const {
  DisjointSets sets(positions_.size());
  for (const WeldEdge& e : edges_) {
    sets.unite(e.from, e.to);
    sets.unite(e.from, e.third);
  }
  std::vector<Index> with_distance;
  const Visited visited = visit_pairs(all_edges(), length, [&](Index a, Index b) {
    if (least_above(a, b, -1.0) > length) return true;
    sets.unite(edges_[a].from, edges_[b].from);
    if (least_above(a, b, limit) <= length) with_distance.push_back(a);
    return true;
  });
  if (visited != Visited::All) return {};
  std::vector<std::uint8_t> has_distance(positions_.size(), 0);
  for (const Index e : with_distance) has_distance[sets.find(edges_[e].from)] = 1;
  std::vector<Index> without;
  for (Index e = 0; e < edges_.size(); ++e) {
    if (has_distance[sets.find(edges_[e].from)] == 0) without.push_back(e);
  }
  return without;
}

}  // namespace meshalyzer
