#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace meshalyzer {

/// U+FFFD, the replacement character.
inline constexpr std::string_view kReplacementCharacter = "\xEF\xBF\xBD";

/// Returns the length in bytes of the UTF-8 sequence that begins at `text[i]`, or 0 if none does.
[[nodiscard]] std::size_t utf8_sequence_length(std::string_view text, std::size_t i);

[[nodiscard]] bool is_utf8(std::string_view text);

/// Converts any bytes to text: each byte becomes the character of the same number (Latin-1).
[[nodiscard]] std::string latin1_to_utf8(std::string_view bytes);

/// Returns the bytes from which latin1_to_utf8() made a text.
/// @return Nothing if the text is not UTF-8 or has a character beyond U+00FF.
[[nodiscard]] std::optional<std::string> utf8_to_latin1(std::string_view text);

}  // namespace meshalyzer
