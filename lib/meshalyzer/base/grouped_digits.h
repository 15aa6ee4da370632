#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace meshalyzer {

/// Formats a whole number for people, with its digits in groups of three: "16,937,291". Output for
/// programs has no groups.
[[nodiscard]] inline std::string grouped(std::size_t number) {
  constexpr std::size_t kGroup = 3;
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > kGroup;) {
    i -= kGroup;
    digits.insert(i, 1, ',');
  }
  return digits;
}

/// Returns a number of things with its noun: "1 face", "2 faces".
[[nodiscard]] inline std::string counted(std::size_t n, std::string_view one,
                                         std::string_view many) {
  std::string text = grouped(n);
  text += ' ';
  text += n == 1 ? one : many;
  return text;
}

}  // namespace meshalyzer
