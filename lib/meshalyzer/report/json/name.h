#pragma once

#include <string>
#include <string_view>

namespace meshalyzer {

/// Returns the name of a file as a key or in a row of JSON; it differs for any different names.
///
/// It is the name itself, except that each byte that is not UTF-8 becomes U+FFFD and its two
/// hexadecimal digits; so do the bytes of U+FFFD itself.
[[nodiscard]] std::string json_name(std::string_view name);

}  // namespace meshalyzer
