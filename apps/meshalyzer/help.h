#pragma once

#include <string_view>

namespace meshalyzer {

/// What --help prints. By hand, for an eye and 80 columns.
[[nodiscard]] std::string_view help_text();

/// What `merge --help` prints.
[[nodiscard]] std::string_view merge_help_text();

}  // namespace meshalyzer
