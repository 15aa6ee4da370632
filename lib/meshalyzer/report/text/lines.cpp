#include "meshalyzer/report/text/lines.h"

#include "meshalyzer/base/control_characters.h"
#include "meshalyzer/base/grouped_digits.h"

#include <fmt/format.h>

namespace meshalyzer {

std::string undefined(std::string_view reason) {
  return reason.empty() ? "undefined" : fmt::format("undefined ({})", reason);
}

std::string arrow(std::size_t before, std::size_t after) {
  return fmt::format("{} -> {}", before, after);
}

void TextLines::heading(std::string_view title) {
  if (!text_.empty()) {
    text_ += '\n';
  }
  text_ += title;
  text_ += '\n';
}

void TextLines::add(std::string_view name, std::string_view value) {
  text_ += without_controls(name);
  text_ += ": ";
  text_ += without_controls(value);
  text_ += '\n';
}

void ReportRows::change(std::string_view name, std::size_t before, std::size_t after) {
  add(name, fmt::format("{} \u2192 {}", grouped(before), grouped(after)));
}

void ReportRows::add(std::string_view name, std::string_view value) {
  rows_.push_back({std::string(name), std::string(value)});
}

std::string ReportRows::count_text(std::size_t count) const {
  return grouped(count);
}

}  // namespace meshalyzer
