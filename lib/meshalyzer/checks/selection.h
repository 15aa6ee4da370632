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

/// Returns an empty text if a name is that of a defect code or of a limit, or kAllCodes; else a
/// phrase that says that it is not, with the code that was most likely meant.
[[nodiscard]] std::string why_no_check_code(std::string_view name);

/// Restricts or extends criteria by names of codes.
///
/// @param selected  If not empty, only these defects and limits are checked; else the criteria
///                  stay.
/// @param ignored   The codes that are not checked.
void select_codes(const std::vector<std::string>& selected, const std::vector<std::string>& ignored,
                  CheckCriteria& criteria);

}  // namespace meshalyzer
