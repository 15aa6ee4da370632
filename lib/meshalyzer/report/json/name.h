#pragma once

#include <string>
#include <string_view>

namespace meshalyzer {

/// Returns the name of a file in JSON, where it is a key or stands in a row: it is different for
/// different names, whatever their bytes.
///
/// It is the name itself, but each byte that is not UTF-8 becomes U+FFFD and its two hexadecimal
/// digits; so do the bytes of U+FFFD itself.
[[nodiscard]] std::string json_name(std::string_view name);

}  // namespace meshalyzer
