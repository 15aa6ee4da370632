#pragma once

#include "meshalyzer/base/types.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// Items by the group that each is in.
class ItemsByGroup {
 public:
  /// @param group_of  The group of each item, 0 ... n_groups - 1; kNoIndex if it is in none.
  /// @complexity      O(#items + #groups).
  ItemsByGroup(std::span<const Index> group_of, std::size_t n_groups);

  [[nodiscard]] std::size_t size() const { return begin_.size() - 1; }

  /// Returns the items of a group, ascending.
  [[nodiscard]] std::span<const Index> operator[](std::size_t group) const {
    return std::span(items_).subspan(begin_[group], begin_[group + 1] - begin_[group]);
  }

 private:
  /// #groups + 1: where the items of each begin.
  std::vector<Index> begin_;
  std::vector<Index> items_;
};

}  // namespace meshalyzer
