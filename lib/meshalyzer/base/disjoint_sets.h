#pragma once

#include "meshalyzer/base/types.h"

#include <cstddef>
#include <numeric>
#include <vector>

namespace meshalyzer {

/// Disjoint sets (union-find) of the numbers 0 ... n - 1, each named by its lowest element.
///
/// The higher root is hung below the lower one and paths are halved: amortised O(log n) a call, and
/// near constant where neighbours have near numbers, as in mesh files.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  /// Returns the lowest element of the set that `i` is in.
  [[nodiscard]] Index find(Index i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  void unite(Index a, Index b) {
    a = find(a);
    b = find(b);
    if (a < b) parent_[b] = a;
    if (b < a) parent_[a] = b;
  }

  [[nodiscard]] bool is_lowest(Index i) const { return parent_[i] == i; }

  /// The number of each set.
  struct Numbers {
    /// #elements entries: the number of the set that contains each, 0 ... count - 1.
    std::vector<Index> of;
    std::size_t count = 0;
  };
  /// Numbers the sets in the order of their lowest elements.
  [[nodiscard]] Numbers number_all() const {
    Numbers numbers{.of = std::vector<Index>(parent_.size())};
    for (std::size_t i = 0; i < parent_.size(); ++i) {
      // A parent is lower than its child, so it has its number already.
      numbers.of[i] =
          parent_[i] == i ? static_cast<Index>(numbers.count++) : numbers.of[parent_[i]];
    }
    return numbers;
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace meshalyzer
