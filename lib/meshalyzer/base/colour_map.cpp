#include "meshalyzer/base/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace meshalyzer {
namespace {

/// Coefficients of a Chebyshev series over t = 0 ... 1.
using Series = std::array<double, 13>;

/// A fit of ours to viridis (Smith and van der Walt, CC0), each channel within 0.35 of 255 steps:
/// with the rounding to a byte no colour is off by more than one step.
constexpr Series kViridisRed{0.40869, 0.29833, 0.25500,  0.08023,  -0.03316, -0.01968, -0.00175,
                             0.00658, 0.00210, -0.00359, -0.00161, 0.00250,  0.00085};
constexpr Series kViridisGreen{0.51873, 0.45465,  -0.05736, -0.00486, -0.00848, 0.00075, 0.00212,
                               0.00085, -0.00036, 0.00013,  0.00015,  -0.00028, 0.00072};
constexpr Series kViridisBlue{0.37589, -0.14674, -0.17065, 0.02113,  0.01486,  0.02881, 0.01471,
                              0.00489, 0.00420,  0.00124,  -0.00057, -0.00079, -0.00176};

constexpr Colour kColdest{33, 80, 170};
constexpr Colour kWhite{255, 255, 255};
constexpr Colour kHottest{178, 30, 45};

/// Clenshaw's recurrence.
double evaluate(const Series& series, double t) {
  const double x = 2.0 * t - 1.0;
  double next = 0.0;
  double after_next = 0.0;
  for (std::size_t i = series.size() - 1; i > 0; --i) {
    const double here = series[i] + 2.0 * x * next - after_next;
    after_next = next;
    next = here;
  }
  return series[0] + x * next - after_next;
}

std::uint8_t to_byte(double intensity) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(intensity, 0.0, 1.0)));
}

std::uint8_t mixed(std::uint8_t from, std::uint8_t to, double share) {
  return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
}

Colour mixed(const Colour& from, const Colour& to, double share) {
  return {mixed(from.red, to.red, share), mixed(from.green, to.green, share),
          mixed(from.blue, to.blue, share)};
}

}  // namespace

Colour colour_of(Palette palette, double t) {
  if (std::isnan(t)) {
    return kNoValueColour;
  }
  t = std::clamp(t, 0.0, 1.0);
  if (palette == Palette::Sequential) {
    return {to_byte(evaluate(kViridisRed, t)), to_byte(evaluate(kViridisGreen, t)),
            to_byte(evaluate(kViridisBlue, t))};
  }
  return t < 0.5 ? mixed(kColdest, kWhite, 2.0 * t) : mixed(kWhite, kHottest, 2.0 * t - 1.0);
}

Colour ColourScale::colour_of(double value) const {
  // Halves, as the whole of the range may be too large for a double.
  const double range = max / 2.0 - min / 2.0;
  const double place = value / 2.0 - min / 2.0;
  const double t = range > 0.0 ? place / range : std::isnan(value) ? value : 0.5;
  return meshalyzer::colour_of(palette, t);
}

ColourScale scale_for(std::span<const double> values) {
  const auto first =
      std::find_if(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  if (first == values.end()) {
    return {};
  }
  double min = *first;
  double max = *first;
  for (const double value : values) {
    if (std::isfinite(value)) {
      min = std::min(min, value);
      max = std::max(max, value);
    }
  }
  if (min < 0.0 && 0.0 < max) {
    const double largest = std::max(-min, max);
    return {Palette::Diverging, -largest, largest};
  }
  return {Palette::Sequential, min, max};
}

}  // namespace meshalyzer
