#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string>

namespace meshalyzer {

/// Returns the number of type T that stands at `at` in the given byte order.
template <typename T>
[[nodiscard]] T load(const char* at, std::endian order) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), at, sizeof(T));
  if (order != std::endian::native) {
    std::reverse(bytes.begin(), bytes.end());
  }
  return std::bit_cast<T>(bytes);
}

/// Appends a number in little-endian byte order.
template <typename T>
void append_little_endian(std::string& content, T value) {
  auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (std::endian::native != std::endian::little) {
    std::reverse(bytes.begin(), bytes.end());
  }
  content.append(bytes.data(), bytes.size());
}

}  // namespace meshalyzer
