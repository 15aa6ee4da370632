#include "meshalyzer/repair/weld/internal/weld_candidates.h"

#include "meshalyzer/base/hash.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/repair/weld/internal/halve_reach.h"
#include "meshalyzer/spatial/segment_grid.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

/// The least width of cells as a fraction of the largest coordinate, about the precision of
/// doubles.
constexpr double kFinestCell = 1e-15;
/// The number of pairs of points in common cells that is always accepted, and the number that is
/// added for each point.
constexpr std::size_t kFewPairs = 1'000'000;
constexpr std::size_t kFewPairsPerPoint = 16;

double largest_coordinate(std::span<const Vec3> positions, std::span<const Index> points) {
  double largest = 0.0;
  for (const Index v : points) largest = std::max(largest, positions[v].cwiseAbs().maxCoeff());
  return largest;
}

}  // namespace

NearPoints::NearPoints(std::span<const Vec3> positions, std::span<const Index> points, double reach)
    : positions_(positions), reach_(std::min(reach, std::numeric_limits<double>::max() / 8)) {
  const double finest = std::max(kFinestCell * largest_coordinate(positions, points),
                                 std::numeric_limits<double>::min());
  const auto sort_within = [&](double within) {
    // Cells are so wide that points within reach are in at most two of them along each axis.
    width_ = std::max(2.01 * within, finest);
    sort_into_cells(points);
  };
  reach_ = halve_until(reach_, [&](double within) {
    sort_within(within);
    return !is_crowded() || width_ <= finest;
  });
  if (width_ != std::max(2.01 * reach_, finest)) sort_within(reach_);
}

std::int64_t NearPoints::cell_of(double coordinate) const {
  constexpr double kFarthest = 2 / kFinestCell;
  return static_cast<std::int64_t>(
      std::clamp(std::floor(coordinate / width_), -kFarthest, kFarthest));
}

NearPoints::Cell NearPoints::cell_of(const Vec3& p) const {
  return {cell_of(p.x()), cell_of(p.y()), cell_of(p.z())};
}

std::size_t NearPoints::first_slot(const Cell& cell) const {
  std::uint64_t hash = 0;
  for (const std::int64_t i : cell) hash = mix_hash(hash, static_cast<std::uint64_t>(i));
  return hash & (slots_.size() - 1);
}

void NearPoints::sort_into_cells(std::span<const Index> points) {
  slots_.assign(std::bit_ceil(2 * points.size() + 1), kNoIndex);
  cells_.clear();
  std::vector<Index> cell_of_point(points.size());
  begin_.assign(1, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Cell cell = cell_of(positions_[points[i]]);
    std::size_t slot = first_slot(cell);
    while (slots_[slot] != kNoIndex && cells_[slots_[slot]] != cell) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    if (slots_[slot] == kNoIndex) {
      slots_[slot] = static_cast<Index>(cells_.size());
      cells_.push_back(cell);
      begin_.push_back(0);
    }
    cell_of_point[i] = slots_[slot];
    ++begin_[slots_[slot]];
  }
  Index sum = 0;
  for (Index& begin : begin_) begin = sum += begin;
  points_.resize(points.size());
  for (std::size_t i = points.size(); i-- > 0;) points_[--begin_[cell_of_point[i]]] = points[i];
}

bool NearPoints::is_crowded() const {
  std::size_t n_pairs = 0;
  for (std::size_t i = 0; i + 1 < begin_.size(); ++i) {
    const std::size_t n = begin_[i + 1] - begin_[i];
    n_pairs += n * n;
  }
  return n_pairs > kFewPairs + kFewPairsPerPoint * points_.size();
}

std::span<const Index> NearPoints::members_of(const Cell& cell) const {
  std::size_t slot = first_slot(cell);
  while (slots_[slot] != kNoIndex && cells_[slots_[slot]] != cell) {
    slot = (slot + 1) & (slots_.size() - 1);
  }
  if (slots_[slot] == kNoIndex) return {};
  const Index i = slots_[slot];
  return std::span(points_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
}

namespace {

/// The number of candidates that is always accepted, and the number that is added for each edge.
constexpr std::size_t kFewCandidates = 20'000;
constexpr std::size_t kFewCandidatesPerEdge = 16;

class CandidateSearch {
 public:
  CandidateSearch(std::span<const Vec3> positions, std::span<const WeldEdge> edges,
                  std::span<const Index> wanted)
      : positions_(positions), edges_(edges), wanted_(wanted) {
    segments_.reserve(wanted.size());
    for (const Index e : wanted) {
      segments_.push_back({positions[edges[e].from], positions[edges[e].to]});
    }
  }

  [[nodiscard]] WeldCandidates run(double reach) const {
    // Only edges at one place, which are joined before, are crowded within the least reach too;
    // then there are none.
    WeldCandidates found;
    found.reach = halve_until(reach, [&](double within) {
      const SegmentGrid grid(segments_, within);
      if (grid.is_crowded()) return false;
      std::vector<WeldJoin> joins = candidates(grid, within);
      if (joins.size() > most_candidates()) return false;
      found.joins = std::move(joins);
      return true;
    });
    return found;
  }

 private:
  [[nodiscard]] std::size_t most_candidates() const {
    return kFewCandidates + kFewCandidatesPerEdge * segments_.size();
  }

  /// Returns all candidates within reach; some of them if they are more than most_candidates().
  [[nodiscard]] std::vector<WeldJoin> candidates(const SegmentGrid& grid, double reach) const {
    std::atomic<std::size_t> n_found = 0;
    const auto found = map_chunks<std::vector<WeldJoin>>(segments_.size(), [&](Chunk chunk) {
      std::vector<WeldJoin> joins;
      for (std::size_t i = chunk.begin; i < chunk.end && n_found <= most_candidates(); ++i) {
        const std::size_t n_before = joins.size();
        grid.visit_near(segments_[i], [&](Index j) {
          if (j > i) consider(wanted_[i], wanted_[j], reach, joins);
        });
        keep_better_runs(n_before, joins);
        n_found += joins.size() - n_before;
      }
      return joins;
    });
    std::vector<WeldJoin> all;
    for (const auto& joins : found) all.insert(all.end(), joins.begin(), joins.end());
    return all;
  }

  void consider(Index first, Index second, double reach, std::vector<WeldJoin>& joins) const {
    const WeldEdge& a = edges_[first];
    const WeldEdge& b = edges_[second];
    if (a.face == b.face) return;
    for (const EdgeRun run : {EdgeRun::Opposite, EdgeRun::Same}) {
      const Index from = partner_of_from(b, run);
      const Index to = partner_of_to(b, run);
      if (are_surely_far(a.from, from, reach) || are_surely_far(a.to, to, reach)) continue;
      const double distance = std::max(length(a.from, from), length(a.to, to));
      if (distance <= reach) joins.push_back({first, second, run, distance});
    }
  }

  [[nodiscard]] double length(Index a, Index b) const {
    return (positions_[a] - positions_[b]).stableNorm();
  }

  /// A cheap test, with a margin for rounding: most pairs of a crowd are far from each other.
  [[nodiscard]] bool are_surely_far(Index a, Index b, double reach) const {
    return (positions_[a] - positions_[b]).cwiseAbs().maxCoeff() > 1.001 * reach;
  }

  /// Sorts those of one edge, and keeps one for each other edge.
  static void keep_better_runs(std::size_t begin, std::vector<WeldJoin>& joins) {
    const auto first = joins.begin() + static_cast<std::ptrdiff_t>(begin);
    std::sort(first, joins.end(), [](const WeldJoin& a, const WeldJoin& b) {
      return std::tie(a.second, a.distance, a.run) < std::tie(b.second, b.distance, b.run);
    });
    const auto same_pair = [](const WeldJoin& a, const WeldJoin& b) {
      return a.second == b.second;
    };
    joins.erase(std::unique(first, joins.end(), same_pair), joins.end());
  }

  std::span<const Vec3> positions_;
  std::span<const WeldEdge> edges_;
  std::span<const Index> wanted_;
  std::vector<Segment> segments_;
};

}  // namespace

WeldCandidates find_weld_candidates(std::span<const Vec3> positions,
                                    std::span<const WeldEdge> edges, std::span<const Index> wanted,
                                    double reach) {
  return CandidateSearch(positions, edges, wanted).run(reach);
}

}  // namespace meshalyzer
