#include "meshalyzer/spatial/segment_grid.h"

#include "meshalyzer/base/hash.h"
#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace meshalyzer {
namespace {

/// Returns the distance, even if the squares of differences would overflow or underflow.
double distance(const Vec3& a, const Vec3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double largest_coordinate(std::span<const Segment> segments) {
  double largest = 0.0;
  for (const Segment& segment : segments) {
    for (const Vec3& end : segment) largest = std::max(largest, end.cwiseAbs().maxCoeff());
  }
  return largest;
}

std::uint64_t mixed_in(std::uint64_t hash, std::int64_t number) {
  return mix_hash(hash, static_cast<std::uint64_t>(number));
}

}  // namespace

double gap_between(const Segment& a, const Segment& b) {
  return std::min(std::max(distance(a[0], b[0]), distance(a[1], b[1])),
                  std::max(distance(a[0], b[1]), distance(a[1], b[0])));
}

SegmentGrid::SegmentGrid(std::span<const Segment> segments, double tolerance)
    : entries_(segments.size()), begin_(std::bit_ceil(segments.size() + 1) + 1) {
  // Cells finer than the spacing of doubles would be of no use.
  const double least = std::max({tolerance, 0x1p-48 * largest_coordinate(segments),
                                 std::numeric_limits<double>::denorm_min()});
  reach_ = 1.25 * least;
  // With wider cells a query more often needs only one of them, but finds many more segments where
  // edges are short.
  for (const double width : {64.0, 16.0, 4.0}) {
    cell_size_ = width * least;
    sort_into_cells(segments);
    if (!is_crowded()) return;
  }
}

void SegmentGrid::sort_into_cells(std::span<const Segment> segments) {
  std::vector<std::uint64_t> keys(segments.size());
  parallel_chunks(segments.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      keys[i] = key_of(cell_of(segments[i][0]), cell_of(segments[i][1]));
    }
  });
  const std::size_t mask = begin_.size() - 2;
  begin_.assign(begin_.size(), 0);
  for (const std::uint64_t key : keys) ++begin_[key & mask];
  Index sum = 0;
  for (Index& begin : begin_) begin = sum += begin;
  for (std::size_t i = keys.size(); i-- > 0;) {
    entries_[--begin_[keys[i] & mask]] = {keys[i], static_cast<Index>(i)};
  }
}

bool SegmentGrid::is_crowded() const {
  constexpr std::size_t kFewPairs = 1'000'000;
  constexpr std::size_t kFewPairsPerSegment = 16;
  std::size_t n_pairs = 0;
  for (std::size_t i = 0; i + 1 < begin_.size(); ++i) {
    const std::size_t n = begin_[i + 1] - begin_[i];
    n_pairs += n * n;
  }
  return n_pairs > kFewPairs + kFewPairsPerSegment * entries_.size();
}

std::int64_t SegmentGrid::cell_of(double coordinate) const {
  constexpr double kFarthest = 0x1p60;
  constexpr double kLargest = std::numeric_limits<double>::max();
  // With a huge tolerance the reach of a point may be infinite, and the size of cells: then there
  // is only one.
  const double cell = std::floor(std::clamp(coordinate, -kLargest, kLargest) / cell_size_);
  return static_cast<std::int64_t>(std::clamp(cell, -kFarthest, kFarthest));
}

std::uint64_t SegmentGrid::cell_of(const Vec3& point) const {
  std::uint64_t hash = 0;
  for (const double x : point) hash = mixed_in(hash, cell_of(x));
  return hash;
}

SegmentGrid::NearCells SegmentGrid::cells_near(const Vec3& point) const {
  NearCells cells;
  cells.size = 1;
  for (const double x : point) {
    const std::int64_t low = cell_of(x - reach_);
    const std::int64_t high = cell_of(x + reach_);
    const std::size_t n = cells.size;
    if (high != low) {
      for (std::size_t i = 0; i < n; ++i) {
        cells.hashes[cells.size++] = mixed_in(cells.hashes[i], high);
      }
    }
    for (std::size_t i = 0; i < n; ++i) cells.hashes[i] = mixed_in(cells.hashes[i], low);
  }
  return cells;
}

}  // namespace meshalyzer
