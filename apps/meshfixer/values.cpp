#include "values.h"

#include "arguments.h"
#include "file_ending.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/format_of.h"

#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace meshalyzer::fixer {
namespace {

/// Calls `use` for each item of a list with commas.
void for_each_item(std::string_view list, const std::function<void(std::string_view)>& use) {
  while (true) {
    const std::size_t comma = list.find(',');
    use(list.substr(0, comma));
    if (comma == std::string_view::npos) return;
    list.remove_prefix(comma + 1);
  }
}

void add_codes(std::string_view item, const std::string& option, CodeList& list) {
  if (const std::optional<DefectCode> one = defect_code(item)) {
    list.codes.insert(*one);
    list.named.insert(*one);
  } else if (item == "all" || item == "default") {
    const DefectCodes more = item == "all" ? DefectCodes::all() : default_fixes();
    for (const DefectCode code : all_defect_codes()) {
      if (more.contains(code)) list.codes.insert(code);
    }
  } else {
    std::vector<std::string_view> names{"all", "default"};
    for (const DefectCode code : all_defect_codes()) names.push_back(defect_name(code));
    throw UsageError(option + " needs defect codes, not '" + std::string(item) + "'" +
                     did_you_mean(item, names));
  }
}

}  // namespace

CodeList to_codes(const std::string& text, const std::string& option) {
  CodeList list;
  for_each_item(text, [&](std::string_view item) { add_codes(item, option, list); });
  return list;
}

Vec3 to_point(const std::string& text, const std::string& option) {
  std::vector<double> numbers;
  bool is_point = true;
  for_each_item(text, [&](std::string_view item) {
    const std::optional<double> value = parse_real(item);
    is_point = is_point && value.has_value() && std::isfinite(*value);
    numbers.push_back(value.value_or(0.0));
  });
  if (!is_point || numbers.size() != 3) {
    refuse_value(option, "a point X,Y,Z of finite numbers", text);
  }
  return {numbers[0], numbers[1], numbers[2]};
}

FillShape to_fill_shape(const std::string& text, const std::string& option) {
  if (text == "auto") return FillShape::Auto;
  if (text == "linear") return FillShape::Linear;
  if (text == "smooth") return FillShape::Smooth;
  refuse_value(option, "auto, linear or smooth", text);
}

Deviation to_deviation(const std::string& text, const std::string& option) {
  if (text.back() == '%') {
    const std::string number = text.substr(0, text.size() - 1);
    return {to_length(number, option) / 100.0, Deviation::Unit::Diagonal};
  }
  return {to_length(text, option), Deviation::Unit::Length};
}

double to_foldover_angle(const std::string& text, const std::string& option) {
  const double degrees = to_real(text, option);
  if (!(degrees >= 0.0 && degrees <= 180.0)) {
    refuse_value(option, "an angle from 0 to 180 degrees", text);
  }
  return degrees;
}

std::string to_page(const std::string& text, const std::string& option) {
  static_cast<void>(require_ending(text, option, {".html", ".htm"}));
  return text;
}

std::string to_output(const std::string& text, const std::string& /*option*/) {
  if (text != "-" && !is_folder_name(text) && !format_of_name(text)) {
    throw UsageError("'" + text + "' has the ending of no known mesh format (" + kMeshEndings +
                     "); if it is a folder, end its name with /");
  }
  return text;
}

bool is_folder_name(const std::string& text) {
  const std::filesystem::path path(text);
  const bool is_dots = path.filename() == "." || path.filename() == "..";
  return text != "-" && (is_dots || !path.has_filename() || !path.has_extension());
}

}  // namespace meshalyzer::fixer
