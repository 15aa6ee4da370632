#pragma once

#include <string>
#include <string_view>

namespace meshalyzer {

/// What a file name is called in JSON, where it is a key or stands in a row: different for
/// different names, whatever their bytes.
///
/// The name itself, but each byte that is not UTF-8 becomes U+FFFD and its two hexadecimal digits;
/// so do the bytes of U+FFFD itself.
[[nodiscard]] std::string json_name(std::string_view name);

}  // namespace meshalyzer
