#include "meshalyzer/base/base64.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace meshalyzer {
namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::size_t kBytesAGroup = 3;
constexpr std::size_t kDigitsAGroup = 4;

/// Reads up to three bytes as one big-endian number; missing bytes count as 0.
std::uint32_t number_of(std::string_view group) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < kBytesAGroup; ++i) {
    number = number << 8U | (i < group.size() ? static_cast<unsigned char>(group[i]) : 0U);
  }
  return number;
}

}  // namespace

void append_base64(std::string& text, std::string_view bytes) {
  const std::size_t n_groups = (bytes.size() + kBytesAGroup - 1) / kBytesAGroup;
  std::size_t at = text.size();
  text.resize(at + kDigitsAGroup * n_groups, '=');
  for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), kBytesAGroup))) {
    const std::string_view group = bytes.substr(0, kBytesAGroup);
    const std::uint32_t number = number_of(group);
    // A group of k bytes needs k + 1 digits; the others are padding.
    for (std::size_t i = 0; i <= group.size(); ++i) {
      text[at + i] = kDigits[number >> (18 - 6 * i) & 63U];
    }
    at += kDigitsAGroup;
  }
}

}  // namespace meshalyzer
