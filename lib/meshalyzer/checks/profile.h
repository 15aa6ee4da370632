#pragma once

#include "meshalyzer/checks/criteria.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace meshalyzer {

/// Named criteria for meshes with a certain purpose.
struct CheckProfile {
  std::string_view name;
  /// A phrase that says what passes.
  std::string_view description;
  CheckCriteria criteria;
};

/// Returns all profiles; the first is the default. A mesh passes `solid` exactly if reports call it
/// good.
[[nodiscard]] std::span<const CheckProfile> check_profiles();

/// Returns the profile with the given name, or null if no profile has it.
[[nodiscard]] const CheckProfile* find_profile(std::string_view name);

/// Returns an empty text if a profile has the given name; else a phrase that says that none has it,
/// with the name that was most likely meant, or all names.
[[nodiscard]] std::string why_no_profile(std::string_view name);

}  // namespace meshalyzer
