#pragma once

#include "meshalyzer/base/hash.h"
#include "meshalyzer/base/types.h"

#include <bit>
#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// Finds points of a list by their coordinates. Points with equal coordinates are the same point
/// (0.0 equals -0.0).
///
/// The table is an open-addressing hash table of indices into the list of points, at most half
/// full.
class PointTable {
 public:
  PointTable() = default;
  /// Makes a table that holds this many points without growing.
  explicit PointTable(std::size_t n_points) : slots_(std::bit_ceil(2 * n_points + 1), kNoIndex) {}

  /// Appends the point to `points` where it is new. `points` must be the same list at every call.
  /// @return The index of the point.
  [[nodiscard]] Index insert(std::vector<Vec3>& points, const Vec3& point) {
    if (points.size() * 2 >= slots_.size()) {
      grow(points);
    }
    const std::size_t slot = find_slot(points, point);
    if (slots_[slot] == kNoIndex) {
      slots_[slot] = static_cast<Index>(points.size());
      points.push_back(point);
    }
    return slots_[slot];
  }

  /// Enters a point of the list, unless an equal one was entered before.
  ///
  /// @pre    The table was made for at least as many points as are entered.
  /// @return The index of the equal point that was entered first.
  [[nodiscard]] Index enter(std::span<const Vec3> points, Index point) {
    const std::size_t slot = find_slot(points, points[point]);
    if (slots_[slot] == kNoIndex) slots_[slot] = point;
    return slots_[slot];
  }

 private:
  [[nodiscard]] std::size_t find_slot(std::span<const Vec3> points, const Vec3& point) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash_position(point) & mask;
    while (slots_[slot] != kNoIndex && points[slots_[slot]] != point) {
      slot = (slot + 1) & mask;
    }
    return slot;
  }

  void grow(const std::vector<Vec3>& points) {
    constexpr std::size_t kFirstSize = 1024;
    slots_.assign(slots_.empty() ? kFirstSize : slots_.size() * 2, kNoIndex);
    for (std::size_t i = 0; i < points.size(); ++i) {
      slots_[find_slot(points, points[i])] = static_cast<Index>(i);
    }
  }

  /// The slots, a power of two of them; kNoIndex marks a free one.
  std::vector<Index> slots_;
};

/// Returns for each point the first one of the list that equals it.
[[nodiscard]] inline std::vector<Index> first_equal_points(std::span<const Vec3> points) {
  PointTable table(points.size());
  std::vector<Index> first(points.size());
  for (Index point = 0; point < points.size(); ++point) first[point] = table.enter(points, point);
  return first;
}

/// Does the same among some points of the list.
///
/// @param some  Their numbers, in any order, also several times.
/// @return      #points: kNoIndex for all others.
[[nodiscard]] inline std::vector<Index> first_equal_points(std::span<const Vec3> points,
                                                           std::span<const Index> some) {
  std::vector<Index> first(points.size(), kNoIndex);
  std::size_t n = 0;
  for (const Index point : some) {
    n += first[point] == kNoIndex ? 1 : 0;
    first[point] = point;
  }
  PointTable table(n);
  for (Index& point : first) {
    if (point != kNoIndex) point = table.enter(points, point);
  }
  return first;
}

}  // namespace meshalyzer
