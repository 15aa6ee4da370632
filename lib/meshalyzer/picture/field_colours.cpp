#include "meshalyzer/picture/field.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace meshalyzer {
namespace {

/// Values that are closer than this share of the whole range differ only by rounding, such as the
/// curvatures in flat regions.
constexpr double kRounding = 1e-9;

/// Returns the value that p percent of all values do not exceed (nearest rank).
///
/// @param values  Must not be empty; is reordered.
double percentile(std::vector<double>& values, std::size_t p) {
  const std::size_t rank = std::max<std::size_t>((p * values.size() + 99) / 100, 1);
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(values.begin(), place, values.end());
  // The sign of a zero must not depend on how equal zeros were reordered.
  return *place + 0.0;
}

/// Returns the ends of the range of colours; 0 ... 0 if there is no finite value.
ColourScale shown_range(const std::vector<double>& values) {
  std::vector<double> finite;
  std::copy_if(values.begin(), values.end(), std::back_inserter(finite),
               [](double value) { return std::isfinite(value); });
  if (finite.empty()) {
    return {};
  }
  const auto [least, most] = std::minmax_element(finite.begin(), finite.end());
  const double min = *least + 0.0;
  const double max = *most + 0.0;
  const double low = percentile(finite, 2);
  const double high = percentile(finite, 98);
  // Halves are used, because the whole range may be too large for a double.
  const bool shows_values = high / 2.0 - low / 2.0 > kRounding * (max / 2.0 - min / 2.0);
  return shows_values ? ColourScale{Palette::Sequential, low, high}
                      : ColourScale{Palette::Sequential, min, max};
}

}  // namespace

ColourScale scale_of(const Field& field) {
  if (field.kind == FieldKind::Category) {
    return scale_for(field.values);
  }
  const ColourScale range = shown_range(field.values);
  if (field.kind == FieldKind::Magnitude) {
    return range;
  }
  const double largest = std::max(std::abs(range.min), std::abs(range.max));
  return {Palette::Diverging, -largest, largest};
}

Colour FieldColours::of(double value) const {
  if (scale) {
    return scale->colour_of(value);
  }
  if (!std::isfinite(value)) {
    return kNoValueColour;
  }
  const auto number = static_cast<std::size_t>(value);
  if (name != FieldName::Defect) {
    return category_colour(number);
  }
  return number == 0 ? kNoDefectColour : category_colour(number - 1);
}

FieldColours colours_of(const Field& field, std::optional<Palette> palette) {
  if (field.kind == FieldKind::Category && !palette) {
    return {field.name, std::nullopt};
  }
  ColourScale scale = scale_of(field);
  scale.palette = palette.value_or(scale.palette);
  return {field.name, scale};
}

}  // namespace meshalyzer
