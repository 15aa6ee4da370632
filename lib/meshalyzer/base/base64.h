#pragma once

#include <string>
#include <string_view>

namespace meshalyzer {

/// Appends bytes as text of A-Z, a-z, 0-9, + and /, filled up with = to whole fours (RFC 4648,
/// section 4); no line ends.
///
/// @complexity O(bytes).
void append_base64(std::string& text, std::string_view bytes);

}  // namespace meshalyzer
