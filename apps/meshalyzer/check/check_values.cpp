#include "check/check_values.h"

#include "arguments.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/checks/profile.h"
#include "meshalyzer/checks/selection.h"

#include <sstream>

namespace meshalyzer {
namespace {

[[noreturn]] void refuse_value(const std::string& option, const std::string& what,
                               const std::string& text) {
  throw UsageError(option + " needs " + what + ", not '" + text + "'");
}

}  // namespace

std::string to_profile_name(const std::string& text, const std::string& option) {
  if (find_profile(text) == nullptr) {
    std::vector<std::string_view> names;
    for (const CheckProfile& profile : check_profiles()) names.push_back(profile.name);
    throw UsageError(option + " needs solid, print, simulation, sheet or exchange, not '" + text +
                     "'" + did_you_mean(text, names));
  }
  return text;
}

CheckFormat to_check_format(const std::string& text, const std::string& option) {
  const std::optional<CheckFormat> format = check_format(text);
  if (!format) {
    std::vector<std::string_view> names;
    for (const CheckFormat each : all_check_formats()) names.push_back(check_format_name(each));
    throw UsageError(option + " needs one of " + names_of(all_check_formats(), check_format_name) +
                     ", not '" + text + "'" + did_you_mean(text, names));
  }
  return *format;
}

ColourChoice to_colour_choice(const std::string& text, const std::string& option) {
  if (text == "always") return ColourChoice::Always;
  if (text == "never") return ColourChoice::Never;
  if (text != "auto") refuse_value(option, "auto, always or never", text);
  return ColourChoice::OnTerminal;
}

OptionTable::Take append_to(std::vector<std::string>& list) {
  return [&list](const std::string& text, const std::string&) { list.push_back(text); };
}

OptionTable::Take append_codes(std::vector<std::string>& list) {
  return [&list](const std::string& text, const std::string& option) {
    std::istringstream codes(text);
    for (std::string code; std::getline(codes, code, ',');) {
      if (!is_check_code(code)) {
        const std::string nearest = nearest_check_code(code);
        throw UsageError(option + ": no code is called '" + code + "'" +
                         (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
      }
      list.push_back(code);
    }
  };
}

}  // namespace meshalyzer
