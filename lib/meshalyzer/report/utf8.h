#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace meshalyzer {

/// U+FFFD, which stands where there is no character.
inline constexpr std::string_view kReplacementCharacter = "\xEF\xBF\xBD";

/// Length in bytes of the UTF-8 sequence that begins at `text[i]`; 0 where none does.
[[nodiscard]] std::size_t utf8_sequence_length(std::string_view text, std::size_t i);

[[nodiscard]] bool is_utf8(std::string_view text);

/// Any bytes as text: each byte becomes the character of the same number (Latin-1).
[[nodiscard]] std::string latin1_to_utf8(std::string_view bytes);

/// Returns the bytes that latin1_to_utf8() made the text of.
/// @return nothing where the text is not UTF-8 or has a character beyond U+00FF.
[[nodiscard]] std::optional<std::string> utf8_to_latin1(std::string_view text);

}  // namespace meshalyzer
