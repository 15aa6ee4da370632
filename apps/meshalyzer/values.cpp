#include "values.h"

#include "arguments.h"
#include "meshalyzer/base/memory_size.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/format_of.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

namespace meshalyzer {
namespace {

/// Rejects a path that was taken for thresholds because these are missing.
[[noreturn]] void refuse_path(const std::string& option, const std::string& text) {
  throw UsageError("the three numbers of " + option + " are missing: '" + option +
                   " AR,ANGLE,LEN " + text + "', as in '" + option + " 100,5,0.1 " + text +
                   "'; 'meshalyzer check " + text + "' judges without numbers");
}

}  // namespace

GoodnessThresholds to_thresholds(const std::string& text, const std::string& option) {
  std::error_code ignored;  // a path that cannot be examined is no path
  if (format_of_name(text) || std::filesystem::exists(text, ignored)) refuse_path(option, text);
  std::string_view rest = without_sign(text);
  std::array<double, 3> numbers{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t comma = rest.find(',');
    const std::optional<double> value = parse_real(rest.substr(0, comma));
    const bool is_last = comma == std::string_view::npos;
    if (!value || std::isnan(*value) || is_last != (i == 2)) {
      refuse_value(option, "three numbers AR,ANGLE,LEN", text);
    }
    numbers[i] = *value;
    rest.remove_prefix(is_last ? rest.size() : comma + 1);
  }
  return {numbers[0], numbers[1], numbers[2]};
}

VertexArea to_area(const std::string& text, const std::string& option) {
  const std::optional<VertexArea> area = vertex_area(text);
  if (!area) {
    refuse_value(option, "mixed, voronoi, barycentric or one-ring", text);
  }
  return *area;
}

FieldName to_field(const std::string& text, const std::string& option) {
  const std::optional<FieldName> field = field_of(text);
  if (!field) {
    refuse_value(option, "one of " + names_of(computed_field_names(), field_name), text);
  }
  return *field;
}

Palette to_palette(const std::string& text, const std::string& option) {
  const std::optional<Palette> palette = palette_of(text);
  if (!palette) {
    refuse_value(option, alternatives_of(all_palettes(), palette_name), text);
  }
  return *palette;
}

double to_cone(const std::string& text, const std::string& option) {
  const double degrees = to_real(text, option);
  if (!(degrees >= 0.0 && degrees <= 90.0)) {
    refuse_value(option, "an angle from 0 to 90 degrees", text);
  }
  return degrees;
}

Shard to_shard(const std::string& text, const std::string& option) {
  const std::size_t slash = text.find('/');
  const std::optional<std::int64_t> k = parse_integer(text.substr(0, slash));
  const std::optional<std::int64_t> n =
      slash == std::string::npos ? std::nullopt : parse_integer(text.substr(slash + 1));
  if (!k || !n || *k < 1 || *k > *n) {
    refuse_value(option, "K/N, the number of the part and of all parts", text);
  }
  return {static_cast<std::size_t>(*k - 1), static_cast<std::size_t>(*n)};
}

std::uint64_t to_bytes(const std::string& text, const std::string& option) {
  const std::optional<std::uint64_t> bytes = parse_memory_size(text);
  if (!bytes) {
    refuse_value(option, "a size such as 500M or 4G", text);
  }
  return *bytes;
}

}  // namespace meshalyzer
