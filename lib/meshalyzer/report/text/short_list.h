#pragma once

#include "meshalyzer/report/text/list_length.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace meshalyzer {

/// The number of items of a list that a report shows by default.
inline constexpr std::size_t kShortList = 12;

/// Returns the number of items of a list of n that are shown.
[[nodiscard]] constexpr std::size_t n_shown(std::size_t n, ListLength lists) {
  return lists == ListLength::Full || n <= kShortList ? n : kShortList;
}

/// Appends the number of items omitted from a list of n.
inline void append_rest(std::string& text, std::size_t n, ListLength lists) {
  const std::size_t shown = n_shown(n, lists);
  if (shown == n) return;
  text += " and ";
  text += std::to_string(n - shown);
  text += " more";
}

/// Appends the first items of a list of n, each after a blank, and the number of the others.
/// @param item  Returns the text of an item.
template <typename Item>
void append_items(std::string& text, std::size_t n, ListLength lists, const Item& item) {
  for (std::size_t i = 0; i < n_shown(n, lists); ++i) {
    text += ' ';
    text += item(i);
  }
  append_rest(text, n, lists);
}

/// Appends the ids of a list as append_items() does.
inline void append_ids(std::string& text, std::span<const std::int64_t> ids, ListLength lists) {
  append_items(text, ids.size(), lists, [&](std::size_t i) { return std::to_string(ids[i]); });
}

}  // namespace meshalyzer
