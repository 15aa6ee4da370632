#pragma once

#include "check/command.h"
#include "option_table.h"

#include <cstddef>
#include <string>
#include <vector>

namespace meshalyzer {

// The parsers for the values of the options of `check`. All throw UsageError if a text is no valid
// value.

[[nodiscard]] std::string to_profile_name(const std::string& text, const std::string& option);
[[nodiscard]] CheckFormat to_check_format(const std::string& text, const std::string& option);
[[nodiscard]] ColourChoice to_colour_choice(const std::string& text, const std::string& option);

/// Returns a function that appends the value to a list.
[[nodiscard]] OptionTable::Take append_to(std::vector<std::string>& list);

/// Returns a function that appends the codes "a,b,c" to a list; each must exist.
[[nodiscard]] OptionTable::Take append_codes(std::vector<std::string>& list);

}  // namespace meshalyzer
