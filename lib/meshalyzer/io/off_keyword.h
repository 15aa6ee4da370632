#pragma once

#include "meshalyzer/io/text_scanner.h"

#include <string_view>

namespace meshalyzer {

/// The data of the vertices of an OFF file in addition to the position, in this order, as the
/// keyword declares.
struct OffLayout {
  bool normal = false;
  bool colour = false;
  bool texture = false;
};

/// Tells whether the word is OFF with any of its prefixes, including those that are not supported.
[[nodiscard]] bool is_off_keyword(std::string_view word);

/// Parses a keyword.
/// @param in  The scanner, which throws if the file is not three-dimensional.
[[nodiscard]] OffLayout parse_off_keyword(std::string_view keyword, const TextScanner& in);

/// Tells whether the first line of the content is the keyword and the word BINARY.
[[nodiscard]] bool is_binary_off(std::string_view content);

}  // namespace meshalyzer
