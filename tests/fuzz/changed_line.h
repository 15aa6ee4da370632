#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

/// Changes to a good line, since chance never hits upon one: of each three bytes two tell where,
/// the third what to write there; 0 cuts the line off.
inline std::string changed_line(std::string line, const std::uint8_t* data, std::size_t size) {
  for (std::size_t i = 0; i + 3 <= size && !line.empty(); i += 3) {
    const std::size_t at = (std::size_t{data[i]} << 8U | data[i + 1]) % line.size();
    if (data[i + 2] == 0) {
      line.resize(at);
    } else {
      line[at] = static_cast<char>(data[i + 2]);
    }
  }
  return line;
}
