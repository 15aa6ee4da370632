#pragma once

#include "meshalyzer/checks/criteria.h"

#include <optional>
#include <span>
#include <string_view>

namespace meshalyzer {

/// Named criteria: what is asked of a mesh that is meant for some purpose.
struct CheckProfile {
  std::string_view name;
  /// A phrase that says what passes.
  std::string_view description;
  CheckCriteria criteria;
};

/// All profiles; the first is the default. What passes `solid` is what reports call good.
[[nodiscard]] std::span<const CheckProfile> check_profiles();

/// The profile that has a name; null where none has it.
[[nodiscard]] const CheckProfile* find_profile(std::string_view name);

}  // namespace meshalyzer
