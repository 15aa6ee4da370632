#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace meshalyzer {

/// Calls `body` with each run of successive items that have the same key.
///
/// @param key  Returns the key of an item, or is the member that is the key.
template <typename Item, typename Key, typename Body>
void for_each_run(std::span<Item> items, const Key& key, const Body& body) {
  for (std::size_t begin = 0; begin < items.size();) {
    std::size_t end = begin + 1;
    while (end < items.size() && std::invoke(key, items[end]) == std::invoke(key, items[begin])) {
      ++end;
    }
    body(items.subspan(begin, end - begin));
    begin = end;
  }
}

}  // namespace meshalyzer
