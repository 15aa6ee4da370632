#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace meshalyzer {

/// Returns the ending of a file to be written, with its dot. It must be one of some: else a slip of
/// the hand, or a pattern of the shell, would write over something else.
/// @param option  That names the file.
/// @throws UsageError where it is none of them.
[[nodiscard]] std::string require_ending(const std::string& file, std::string_view option,
                                         std::initializer_list<std::string_view> endings);

}  // namespace meshalyzer
