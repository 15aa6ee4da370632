#pragma once

#include <algorithm>

namespace meshalyzer {

/// Sorts a list and removes repeated elements.
///
/// @complexity  O(n log n).
template <typename List>
void sort_unique(List& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace meshalyzer
