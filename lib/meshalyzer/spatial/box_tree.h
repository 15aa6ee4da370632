#pragma once

#include "meshalyzer/base/types.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// A bounding volume hierarchy over boxes: an implicit, complete tree with eight children per node
/// over the boxes, ordered along a Z-order curve through their centres (Morton 1966).
class BoxTree {
 public:
  /// @param boxes  The boxes, of which empty ones are ignored.
  /// @complexity   O(n log n).
  explicit BoxTree(std::span<const Box3> boxes);

  /// Returns the numbers of the boxes in an order in which neighbours in space mostly follow each
  /// other.
  [[nodiscard]] const std::vector<Index>& order() const { return order_; }

  /// Returns the boxes that share a point with a given one, ascending.
  ///
  /// @complexity O(log n + found) for boxes that are spread out.
  [[nodiscard]] std::vector<Index> meeting(const Box3& box) const;

 private:
  void collect(std::size_t level, std::size_t i, const Box3& box, std::vector<Index>& found) const;

  std::vector<Index> order_;
  /// Level 0 holds the boxes in that order; each box of a higher level contains eight of the level
  /// below.
  std::vector<std::vector<Box3>> levels_;
};

}  // namespace meshalyzer
