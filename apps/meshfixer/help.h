#pragma once

#include <string_view>

namespace meshalyzer::fixer {

/// What --help prints.
[[nodiscard]] std::string_view help_text();

}  // namespace meshalyzer::fixer
