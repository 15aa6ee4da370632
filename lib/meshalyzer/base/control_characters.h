#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace meshalyzer {

/// Returns the length in bytes of the control character that begins at `text[i]` in ASCII or
/// UTF-8, or 0 if none does. Controls of the direction of writing that hold beyond the word they
/// stand in (U+202A ... U+202E, U+2066 ... U+2069) are among them, because they turn the text round
/// that follows.
[[nodiscard]] std::size_t control_length(std::string_view text, std::size_t i);

/// Returns a text for a line that people read: each control character, which would end the line or
/// steer the terminal, becomes "?". Names of files may have such characters.
[[nodiscard]] std::string without_controls(std::string_view text);

}  // namespace meshalyzer
