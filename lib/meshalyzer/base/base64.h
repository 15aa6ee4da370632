#pragma once

#include <string>
#include <string_view>

namespace meshalyzer {

/// Appends bytes as text of A-Z, a-z, 0-9, + and /, padded with = to a multiple of four digits (RFC
/// 4648, section 4), without line ends.
///
/// @complexity O(bytes).
void append_base64(std::string& text, std::string_view bytes);

}  // namespace meshalyzer
