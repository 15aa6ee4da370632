#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace meshalyzer {

/// Returns a number with its noun: "1 face", "12 faces".
[[nodiscard]] inline std::string count_of(std::size_t n, std::string_view noun) {
  std::string text = std::to_string(n);
  text += ' ';
  text += noun;
  if (n != 1) text += 's';
  return text;
}

}  // namespace meshalyzer
