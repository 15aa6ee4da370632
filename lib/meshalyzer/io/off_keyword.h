#pragma once

#include "meshalyzer/io/text_scanner.h"

#include <string_view>

namespace meshalyzer {

/// What vertices of an OFF file hold besides the position, in this order, as the keyword says.
struct OffLayout {
  bool normal = false;
  bool colour = false;
  bool texture = false;
};

/// Tells whether the word is OFF with any of its prefixes, those that are not read included.
[[nodiscard]] bool is_off_keyword(std::string_view word);

/// Understands a keyword.
/// @param in  Faults where it is that of a file in other than three dimensions.
[[nodiscard]] OffLayout parse_off_keyword(std::string_view keyword, const TextScanner& in);

/// Tells whether the first line of the content is the keyword and the word BINARY.
[[nodiscard]] bool is_binary_off(std::string_view content);

}  // namespace meshalyzer
