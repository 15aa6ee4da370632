#pragma once

#include "meshalyzer/base/types.h"

#include <cstddef>
#include <numeric>
#include <vector>

namespace meshalyzer {

/// Sets of the numbers 0 ... n - 1, each named by its lowest element.
///
/// The higher root is hung below the lower one and paths are halved: amortised O(log n) a call, and
/// near constant where neighbours have near numbers, as in mesh files.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  /// The lowest element of the set that `i` is in.
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

  /// An element of the same set: `i` itself where it is the lowest, else a lower one.
  [[nodiscard]] Index parent(Index i) const { return parent_[i]; }

 private:
  std::vector<Index> parent_;
};

}  // namespace meshalyzer
