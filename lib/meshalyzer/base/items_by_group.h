#pragma once

#include "meshalyzer/base/types.h"

#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace meshalyzer {

/// Items by the group that each is in.
class ItemsByGroup {
 public:
  /// There are no groups.
  ItemsByGroup() = default;

  /// @param group_of  The group of each item, 0 ... n_groups - 1; kNoIndex if it is in none.
  /// @complexity      O(#items + #groups).
  ItemsByGroup(std::span<const Index> group_of, std::size_t n_groups);

  /// Groups items that may be in several groups, or in one several times.
  ///
  /// @param for_each  Calls the function that it is given with each group, 0 ... n_groups - 1, and
  ///                  an item in it. It is called twice and must visit the same both times.
  /// @complexity      O(#items + #groups).
  template <typename ForEach>
  ItemsByGroup(std::size_t n_groups, const ForEach& for_each) : begin_(n_groups + 2, 0) {
    // The counts stand two groups up, so that filling moves every begin into its place.
    for_each([&](std::size_t group, Index) { ++begin_[group + 2]; });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    items_.resize(begin_.back());
    for_each([&](std::size_t group, Index item) { items_[begin_[group + 1]++] = item; });
    begin_.pop_back();
  }

  [[nodiscard]] std::size_t size() const { return begin_.size() - 1; }

  /// Returns the items of a group in the order in which they were given.
  [[nodiscard]] std::span<const Index> operator[](std::size_t group) const {
    return std::span(items_).subspan(begin_[group], begin_[group + 1] - begin_[group]);
  }

 private:
  /// #groups + 1: where the items of each begin.
  std::vector<Index> begin_{0};
  std::vector<Index> items_;
};

}  // namespace meshalyzer
