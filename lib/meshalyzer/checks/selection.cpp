#include "meshalyzer/checks/selection.h"

#include "meshalyzer/base/nearest_name.h"

#include <algorithm>
#include <fmt/format.h>

namespace meshalyzer {
namespace {

bool has(const std::vector<std::string>& names, std::string_view name) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& each) { return each == name || each == kAllCodes; });
}

/// Returns the names that lists of codes may have.
std::vector<std::string_view> selectable_names() {
  std::vector<std::string_view> names = all_check_codes();
  names.insert(names.begin(), kAllCodes);
  return names;
}

}  // namespace

std::vector<std::string_view> all_check_codes() {
  std::vector<std::string_view> names;
  for (const DefectCode code : all_defect_codes()) names.push_back(defect_name(code));
  for (const LimitInfo& info : limit_table()) names.push_back(info.name);
  return names;
}

std::string why_no_check_code(std::string_view name) {
  const std::vector<std::string_view> names = selectable_names();
  if (std::find(names.begin(), names.end(), name) != names.end()) return "";
  return fmt::format("no code is called '{}'{}", name, did_you_mean(name, names));
}

void select_codes(const std::vector<std::string>& selected, const std::vector<std::string>& ignored,
                  CheckCriteria& criteria) {
  for (const DefectCode code : all_defect_codes()) {
    const std::string_view name = defect_name(code);
    if (!selected.empty() && has(selected, name)) criteria.codes.insert(code);
    if ((!selected.empty() && !has(selected, name)) || has(ignored, name)) {
      criteria.codes.erase(code);
    }
  }
  for (const LimitInfo& info : limit_table()) {
    if ((!selected.empty() && !has(selected, info.name)) || has(ignored, info.name)) {
      criteria.limits[info.kind].reset();
    }
  }
}

}  // namespace meshalyzer
