#pragma once

#include <cstddef>
#include <string>

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

}  // namespace meshalyzer
