#pragma once

#include "meshalyzer/base/types.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// Returns the numbers of the boxes that are not empty along a Z-order curve through their centres
/// (Morton 1966): neighbours in space mostly follow each other.
///
/// @complexity O(n log n).
[[nodiscard]] std::vector<Index> order_in_space(std::span<const Box3> boxes);

/// A bounding volume hierarchy over boxes: an implicit, complete tree with eight children per node
/// over the boxes in the order of order_in_space().
class BoxTree {
 public:
  /// @param boxes  The boxes, of which empty ones are ignored. They may be infinite.
  /// @complexity   O(n log n).
  explicit BoxTree(std::span<const Box3> boxes);

  /// Returns the numbers of the boxes as order_in_space() does.
  [[nodiscard]] const std::vector<Index>& order() const { return order_; }

  /// Returns the boxes that share a point with a given one, ascending.
  ///
  /// @complexity O(log n + found) for boxes that are spread out.
  [[nodiscard]] std::vector<Index> meeting(const Box3& box) const;

  /// Tells whether one of the boxes shares a point with a given one, which is not empty.
  ///
  /// @complexity O(log n) for boxes that are spread out.
  [[nodiscard]] bool meets_any(const Box3& box) const;

 private:
  [[nodiscard]] bool meets_below(std::size_t level, std::size_t i, const Box3& box) const;
  void collect(std::size_t level, std::size_t i, const Box3& box, std::vector<Index>& found) const;

  std::vector<Index> order_;
  /// Level 0 holds the boxes in that order; each box of a higher level contains eight of the level
  /// below.
  std::vector<std::vector<Box3>> levels_;
};

}  // namespace meshalyzer
