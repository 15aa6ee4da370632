#pragma once

#include <algorithm>
#include <vector>

namespace meshalyzer {

/// Sorts a list and leaves each of its items once.
template <typename Item>
void sort_unique(std::vector<Item>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace meshalyzer
