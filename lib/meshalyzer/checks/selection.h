#pragma once

#include "meshalyzer/checks/criteria.h"

#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// Stands for all codes in a list of codes.
inline constexpr std::string_view kAllCodes = "all";

/// Returns the names of all defect codes and limits.
[[nodiscard]] std::vector<std::string_view> all_check_codes();

/// Tells whether a name is that of a defect code or of a limit, or kAllCodes.
[[nodiscard]] bool is_check_code(std::string_view name);

/// Returns the code that a mistyped name most likely means; empty where none is near.
[[nodiscard]] std::string nearest_check_code(std::string_view name);

/// Narrows or widens criteria by names of codes.
///
/// @param selected  Where there are any, only these defects are looked for, and limits only where
/// they are among these; else all as they are.
/// @param ignored   Not looked for.
void select_codes(const std::vector<std::string>& selected, const std::vector<std::string>& ignored,
                  CheckCriteria& criteria);

}  // namespace meshalyzer
