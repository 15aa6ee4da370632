#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace meshalyzer {

/// Returns the ending of a file to be written, with its dot. It must be one of the given ones:
/// otherwise a typing error, or a shell pattern, could overwrite another file.
/// @param option  The option that names the file.
/// @throws UsageError if it is none of them.
[[nodiscard]] std::string require_ending(const std::string& file, std::string_view option,
                                         std::initializer_list<std::string_view> endings);

}  // namespace meshalyzer
