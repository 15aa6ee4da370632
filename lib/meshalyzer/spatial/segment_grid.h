#pragma once

#include "meshalyzer/base/hash.h"
#include "meshalyzer/base/types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// The two ends of a straight edge.
using Segment = std::array<Vec3, 2>;

/// Returns how far two segments are from having the same ends: the larger distance between
/// corresponding ends, in the better of the two directions. It is 0 exactly if the ends coincide.
[[nodiscard]] double gap_between(const Segment& a, const Segment& b);

/// Finds the segments that nearly coincide, by the two grid cells that contain their ends.
///
/// A pair of cells separates better than the cell of one end or of the midpoint: the edges of a fan
/// share an end and the diagonals of a box their midpoint, but only edges that nearly coincide
/// share both ends.
class SegmentGrid {
 public:
  /// @param tolerance  A finite length.
  /// @complexity       O(n).
  SegmentGrid(std::span<const Segment> segments, double tolerance);

  /// Tells whether so many segments are in the same cells that visiting all of them would take
  /// long.
  [[nodiscard]] bool is_crowded() const;

  /// Calls `visit` with the number of each segment whose ends may be within the tolerance of the
  /// ends of this one. The order is arbitrary, some segments are farther away, and short ones may
  /// come twice.
  ///
  /// @complexity O(1 + found).
  template <typename Visit>
  void visit_near(const Segment& segment, Visit&& visit) const {
    const NearCells at_first = cells_near(segment[0]);
    const NearCells at_second = cells_near(segment[1]);
    for (std::size_t i = 0; i < at_first.size; ++i) {
      for (std::size_t j = 0; j < at_second.size; ++j) {
        const std::uint64_t key = key_of(at_first.hashes[i], at_second.hashes[j]);
        for (const Entry& entry : bucket(key)) {
          if (entry.key == key) visit(entry.segment);
        }
      }
    }
  }

 private:
  /// The hashes of cells. Segments in two cells with the same hash are found together; the caller
  /// separates them by their distance.
  struct NearCells {
    std::array<std::uint64_t, 8> hashes{};
    std::size_t size = 0;
  };
  struct Entry {
    std::uint64_t key = 0;
    Index segment = 0;
  };

  void sort_into_cells(std::span<const Segment> segments);
  [[nodiscard]] std::int64_t cell_of(double coordinate) const;
  [[nodiscard]] std::uint64_t cell_of(const Vec3& point) const;
  [[nodiscard]] NearCells cells_near(const Vec3& point) const;
  /// Returns the key of a pair of cells, which is the same for both directions of a segment.
  [[nodiscard]] static std::uint64_t key_of(std::uint64_t a, std::uint64_t b) {
    return mix_hash(a + b, 0);
  }
  [[nodiscard]] std::span<const Entry> bucket(std::uint64_t key) const {
    const std::size_t i = key & (begin_.size() - 2);
    return std::span(entries_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
  }

  /// Ends within the tolerance are within this distance in spite of rounding.
  double reach_ = 0.0;
  double cell_size_ = 1.0;
  /// The entries bucket by bucket, and where each bucket begins (#buckets + 1 places); the number
  /// of buckets is a power of two.
  std::vector<Entry> entries_;
  std::vector<Index> begin_;
};

}  // namespace meshalyzer
