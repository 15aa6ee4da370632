#pragma once

#include "check/command.h"
#include "option_table.h"

#include <cstddef>
#include <string>
#include <vector>

namespace meshalyzer {

// How the values of the options of `check` are read. All throw UsageError where a text says none.

[[nodiscard]] std::string to_profile_name(const std::string& text, const std::string& option);
[[nodiscard]] CheckFormat to_check_format(const std::string& text, const std::string& option);
[[nodiscard]] ColourChoice to_colour_choice(const std::string& text, const std::string& option);

/// Appends the value to a list.
[[nodiscard]] OptionTable::Take append_to(std::vector<std::string>& list);

/// Appends the codes "a,b,c" to a list; each must be one.
[[nodiscard]] OptionTable::Take append_codes(std::vector<std::string>& list);

}  // namespace meshalyzer
