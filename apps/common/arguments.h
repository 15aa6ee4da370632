#pragma once

#include "usage_error.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace meshalyzer {

// What the values of options of both programs are read with: our own parsers, so that no locale
// reads numbers.

/// Returns the text without the sign that the parser leaves in the value of `-g=...`.
[[nodiscard]] std::string_view without_sign(std::string_view text);

/// @throws UsageError if the text is no number.
[[nodiscard]] double to_real(const std::string& text, const std::string& option);

/// @throws UsageError if the text is no finite length, 0 or more.
[[nodiscard]] double to_length(const std::string& text, const std::string& option);

/// How many threads at most.
/// @throws UsageError if the text is no such number.
[[nodiscard]] std::size_t to_thread_count(const std::string& text, const std::string& option);

/// How many of something, 0 or more.
/// @throws UsageError if the text is no such number.
[[nodiscard]] std::size_t to_count(const std::string& text, const std::string& option);

/// Seconds, 0 or more.
/// @throws UsageError if the text is no such number.
[[nodiscard]] double to_seconds(const std::string& text, const std::string& option);

/// How many times something, at least once.
/// @throws UsageError if the text is no such number.
[[nodiscard]] std::uint64_t to_ratio(const std::string& text, const std::string& option);

/// Returns the question whether a mistyped name means the nearest of some: "; did you mean
/// 'hole'?"; empty where none is near.
[[nodiscard]] std::string did_you_mean(std::string_view mistyped,
                                       std::span<const std::string_view> names);

/// Returns the names of some values, "a, b, c".
template <typename Values, typename Name>
std::string names_of(const Values& values, const Name& name) {
  std::string text;
  for (const auto value : values) {
    text += (text.empty() ? "" : ", ") + std::string(name(value));
  }
  return text;
}

}  // namespace meshalyzer
