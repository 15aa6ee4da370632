#pragma once

#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <functional>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>
#include <vector>

namespace meshalyzer {

/// Sorts a list, in parallel where it pays.
///
/// The sort is not stable. So that the result does not depend on the number of threads, items of
/// which none comes before the other must be equal.
template <typename Item, typename Before = std::less<>>
void parallel_sort(std::vector<Item>& items, const Before& comes_before = {}) {
  if (items.size() <= kChunkLength || max_threads() == 1) {
    std::sort(items.begin(), items.end(), comes_before);
  } else {
    tbb::this_task_arena::isolate(
        [&] { tbb::parallel_sort(items.begin(), items.end(), comes_before); });
  }
}

/// Sorts a list in parallel where it pays, and removes repeated elements.
template <typename Item>
void parallel_sort_unique(std::vector<Item>& items) {
  parallel_sort(items);
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace meshalyzer
