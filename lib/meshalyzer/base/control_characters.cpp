#include "meshalyzer/base/control_characters.h"

#include <algorithm>

namespace meshalyzer {
namespace {

bool is_between(std::string_view low, std::string_view text, std::string_view high) {
  return low <= text && text <= high;
}

}  // namespace

std::size_t control_length(std::string_view text, std::size_t i) {
  const auto code = static_cast<unsigned char>(text[i]);
  if (code < 0x20U || code == 0x7FU) return 1;
  if (is_between("\u0080", text.substr(i, 2), "\u009F")) return 2;
  const std::string_view three = text.substr(i, 3);
  const bool is_direction =
      is_between("\u202A", three, "\u202E") || is_between("\u2066", three, "\u2069");
  return is_direction ? 3 : 0;
}

std::string without_controls(std::string_view text) {
  std::string line;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = control_length(text, i);
    line += length > 0 ? '?' : text[i];
    i += std::max<std::size_t>(1, length);
  }
  return line;
}

}  // namespace meshalyzer
