#include "meshalyzer/geometry/crowded_points.h"

#include "meshalyzer/base/hash.h"
#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace meshalyzer {
namespace {

/// The number of cells along the longest side of the box. It is no round number, so that regular
/// grids do not lie on the walls of cells.
constexpr double kCells = 40503.7;

/// About one in as many points shares its slot with one of another cell.
constexpr std::size_t kSlotsPerPoint = 16;

/// Returns a distance that is more than coordinates at the same place can differ by: if |a - b| is
/// at most t = 1e-10 max(1, |a|, |b|), max(1, |b|) is at most (1 + 2e-10) max(1, |a|), and t is far
/// below twice 1e-10 max(1, |a|).
double reach(double coordinate) {
  return 2e-10 * std::max(1.0, std::abs(coordinate));
}

/// A grid of cubes, each of which has a slot of a hash table. A slot knows whether no point, one
/// point, or more have been near one of its cubes.
class Occupancy {
 public:
  Occupancy(std::span<const Vec3> positions, const Box3& box)
      : low_(box.min()),
        per_unit_(kCells / box.sizes().maxCoeff()),
        mask_(std::bit_ceil(kSlotsPerPoint * positions.size()) - 1),
        seen_(mask_ / 64 + 1, 0),
        seen_again_(mask_ / 64 + 1, 0) {}

  /// Tells whether the cells can be counted, and are far wider than what points may be apart by.
  [[nodiscard]] bool is_useful(const Box3& box) const {
    const double largest =
        std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    return std::isnormal(per_unit_) && reach(largest) * per_unit_ < 0.125;
  }

  /// Marks all cells in which there may be a point at the same place. Cells are a monotone function
  /// of a coordinate, also as rounded, so that it is enough to know those of both ends.
  void mark(const Vec3& p) {
    std::array<Cell, 2> ends;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double distance = reach(p[k]);
      ends[0][static_cast<std::size_t>(k)] = cell(p[k] - distance, k);
      ends[1][static_cast<std::size_t>(k)] = cell(p[k] + distance, k);
    }
    for (std::uint32_t x = ends[0][0]; x <= ends[1][0]; ++x) {
      for (std::uint32_t y = ends[0][1]; y <= ends[1][1]; ++y) {
        for (std::uint32_t z = ends[0][2]; z <= ends[1][2]; ++z) mark_slot(slot({x, y, z}));
      }
    }
  }

  /// Tells whether another point may be near that of a marked point.
  [[nodiscard]] bool is_crowded(const Vec3& p) const {
    const std::size_t i = slot({cell(p[0], 0), cell(p[1], 1), cell(p[2], 2)});
    return (seen_again_[i / 64] >> (i % 64) & 1U) != 0;
  }

 private:
  using Cell = std::array<std::uint32_t, 3>;

  /// Less than 2^16. Adding 1 keeps the cells of points just outside the box positive.
  [[nodiscard]] std::uint32_t cell(double coordinate, Eigen::Index axis) const {
    return static_cast<std::uint32_t>((coordinate - low_[axis]) * per_unit_ + 1.0);
  }
  [[nodiscard]] std::size_t slot(const Cell& c) const {
    return mix_hash(0, std::uint64_t{c[0]} << 32U | std::uint64_t{c[1]} << 16U | c[2]) & mask_;
  }
  void mark_slot(std::size_t i) {
    const std::uint64_t bit = std::uint64_t{1} << (i % 64);
    seen_again_[i / 64] |= seen_[i / 64] & bit;
    seen_[i / 64] |= bit;
  }

  Vec3 low_;
  double per_unit_;
  std::size_t mask_;
  std::vector<std::uint64_t> seen_;
  std::vector<std::uint64_t> seen_again_;
};

std::vector<Index> all_points(std::size_t n) {
  std::vector<Index> all(n);
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

}  // namespace

std::vector<Index> find_crowded_points(std::span<const Vec3> positions) {
  Box3 box;
  for (const Vec3& p : positions) box.extend(p);
  if (positions.empty()) return {};
  Occupancy cells(positions, box);
  if (!cells.is_useful(box)) return all_points(positions.size());
  for (const Vec3& p : positions) cells.mark(p);
  return parallel_filter(positions.size(), [&](Index i) { return cells.is_crowded(positions[i]); });
}

}  // namespace meshalyzer
