#pragma once

#include "meshalyzer/base/types.h"

#include <atomic>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace meshalyzer {

/// Disjoint sets (union-find) of the numbers 0 ... n - 1, each named by its lowest element.
///
/// The higher root is hung below the lower one and paths are halved: amortised O(log n) a call, and
/// near constant where neighbours have near numbers, as in mesh files. Several threads may unite
/// and find at a time, without locks (Anderson and Woll 1991): a parent is always a lower element
/// of the same set, and only a root gets another one by comparing and exchanging.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  /// Returns the lowest element of the set that `i` is in.
  [[nodiscard]] Index find(Index i) {
    for (;;) {
      const Index parent = shared(i).load(std::memory_order_relaxed);
      const Index grandparent = shared(parent).load(std::memory_order_relaxed);
      if (parent == grandparent) return parent;
      shared(i).store(grandparent, std::memory_order_relaxed);
      i = grandparent;
    }
  }

  void unite(Index a, Index b) {
    for (;;) {
      a = find(a);
      b = find(b);
      if (a == b) return;
      if (a < b) std::swap(a, b);
      Index root = a;
      if (shared(a).compare_exchange_strong(root, b, std::memory_order_relaxed)) return;
    }
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
  [[nodiscard]] std::atomic_ref<Index> shared(Index i) { return std::atomic_ref(parent_[i]); }

  std::vector<Index> parent_;
};

}  // namespace meshalyzer
