#pragma once

#include "meshalyzer/base/nearest_name.h"
#include "usage_error.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace meshalyzer {

// The parsers for the values of options of both programs; they do not depend on the locale.

/// Rejects a text that is no value of an option.
/// @param wanted  What the option needs, as in "a number".
/// @throws UsageError always.
[[noreturn]] void refuse_value(const std::string& option, const std::string& wanted,
                               const std::string& text);

/// Returns the text without the sign that the parser leaves in the value of `-g=...`.
[[nodiscard]] std::string_view without_sign(std::string_view text);

/// Returns a number.
/// @throws UsageError if the text is no number.
[[nodiscard]] double to_real(const std::string& text, const std::string& option);

/// Returns a finite length, 0 or more.
/// @throws UsageError if the text is no such length.
[[nodiscard]] double to_length(const std::string& text, const std::string& option);

/// Returns the largest number of threads.
/// @throws UsageError if the text is no such number.
[[nodiscard]] std::size_t to_thread_count(const std::string& text, const std::string& option);

/// Returns a count, 0 or more.
/// @throws UsageError if the text is no such number.
[[nodiscard]] std::size_t to_count(const std::string& text, const std::string& option);

/// Returns a time in seconds, 0 or more.
/// @throws UsageError if the text is no such number.
[[nodiscard]] double to_seconds(const std::string& text, const std::string& option);

/// Returns a count, 1 or more.
/// @throws UsageError if the text is no such number.
[[nodiscard]] std::size_t to_count_from_one(const std::string& text, const std::string& option);

/// Returns the names of some values, "a, b, c".
template <typename Values, typename Name>
std::string names_of(const Values& values, const Name& name) {
  std::string text;
  for (const auto value : values) {
    text += (text.empty() ? "" : ", ") + std::string(name(value));
  }
  return text;
}

/// Returns the names of some values as alternatives, "a, b or c".
template <typename Values, typename Name>
std::string alternatives_of(const Values& values, const Name& name) {
  std::string text = names_of(values, name);
  const std::size_t last = text.rfind(", ");
  return last == std::string::npos ? text : text.replace(last, 2, " or ");
}

}  // namespace meshalyzer
