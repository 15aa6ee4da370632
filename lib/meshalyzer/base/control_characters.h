#pragma once

#include <string>
#include <string_view>

namespace meshalyzer {

/// Returns a text for a line that people read: each control character, which would end the line or
/// steer the terminal, becomes "?". Names of files may have such characters.
[[nodiscard]] std::string without_controls(std::string_view text);

}  // namespace meshalyzer
