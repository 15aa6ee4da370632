#pragma once

#include "meshalyzer/checks/criteria.h"

#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The name that stands for all codes in a list of codes.
inline constexpr std::string_view kAllCodes = "all";

/// Returns the names of all defect codes and limits.
[[nodiscard]] std::vector<std::string_view> all_check_codes();

/// Tells whether a name is that of a defect code or of a limit, or kAllCodes.
[[nodiscard]] bool is_check_code(std::string_view name);

/// Returns the code that a mistyped name most likely means; empty if none is close.
[[nodiscard]] std::string nearest_check_code(std::string_view name);

/// Restricts or extends criteria by names of codes.
///
/// @param selected  If not empty, only these defects and limits are checked; else the criteria
///                  stay.
/// @param ignored   The codes that are not checked.
void select_codes(const std::vector<std::string>& selected, const std::vector<std::string>& ignored,
                  CheckCriteria& criteria);

}  // namespace meshalyzer
