#pragma once

#include "meshalyzer/base/types.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// A bounding volume hierarchy over boxes: an implicit, complete tree of eight children a node over
/// the boxes in order along a Z-order curve through their middles (Morton 1966).
class BoxTree {
 public:
  /// @param boxes  Empty ones are left out.
  /// @complexity   O(n log n).
  explicit BoxTree(std::span<const Box3> boxes);

  /// The boxes by number, in an order in which neighbours in space mostly follow each other.
  [[nodiscard]] const std::vector<Index>& order() const { return order_; }

  /// Returns the boxes that share a point with a given one, ascending.
  ///
  /// @complexity O(log n + found) for boxes that are spread out.
  [[nodiscard]] std::vector<Index> meeting(const Box3& box) const;

 private:
  void collect(std::size_t level, std::size_t i, const Box3& box, std::vector<Index>& found) const;

  std::vector<Index> order_;
  /// Level 0: the boxes in that order; each level boxes eight of the one below.
  std::vector<std::vector<Box3>> levels_;
};

}  // namespace meshalyzer
