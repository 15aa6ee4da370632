#pragma once

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/report/text/list_length.h"

#include <cstddef>
#include <string>
#include <string_view>

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

/// Returns "1 face" or "2 faces".
[[nodiscard]] inline std::string counted(std::size_t n, std::string_view one,
                                         std::string_view many) {
  std::string text = grouped(n);
  text += ' ';
  text += n == 1 ? one : many;
  return text;
}

}  // namespace meshalyzer
