#include "meshalyzer/base/colour_map.h"

#include "meshalyzer/base/find_named.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace meshalyzer {
namespace {

/// Coefficients of a Chebyshev series over t = 0 ... 1.
using Series = std::array<double, 13>;

/// Approximates viridis (Smith and van der Walt, CC0) by our own fit, each channel within 0.35 of
/// 255 steps: after rounding to a byte no colour is off by more than one step.
constexpr Series kViridisRed{0.40869, 0.29833, 0.25500,  0.08023,  -0.03316, -0.01968, -0.00175,
                             0.00658, 0.00210, -0.00359, -0.00161, 0.00250,  0.00085};
constexpr Series kViridisGreen{0.51873, 0.45465,  -0.05736, -0.00486, -0.00848, 0.00075, 0.00212,
                               0.00085, -0.00036, 0.00013,  0.00015,  -0.00028, 0.00072};
constexpr Series kViridisBlue{0.37589, -0.14674, -0.17065, 0.02113,  0.01486,  0.02881, 0.01471,
                              0.00489, 0.00420,  0.00124,  -0.00057, -0.00079, -0.00176};

/// Any two of these colours, and each of them and white, black, or a grey of the pages, are at
/// least 0.15 apart in Oklab (Ottosson 2020), 0.08 as eyes without red or green cones see them, and
/// 0.07 without blue ones (Machado, Oliveira and Fernandes 2009, "A physiologically-based model for
/// simulation of color vision deficiency"). They were found by a search of ours: each is as far as
/// possible from those before it.
constexpr std::array<Colour, kDistinctCategories> kDistinct{{{0, 105, 150},
                                                             {240, 15, 15},
                                                             {0, 195, 120},
                                                             {135, 135, 255},
                                                             {120, 0, 240},
                                                             {255, 210, 0},
                                                             {105, 0, 120},
                                                             {0, 30, 180},
                                                             {255, 150, 195},
                                                             {240, 135, 0},
                                                             {255, 45, 210},
                                                             {150, 60, 75},
                                                             {0, 210, 255},
                                                             {75, 60, 0},
                                                             {105, 255, 150}}};

constexpr Colour kBlack{0, 0, 0};
constexpr Colour kColdest{33, 80, 170};
constexpr Colour kWhite{255, 255, 255};
constexpr Colour kHottest{178, 30, 45};

/// Evaluates the series by Clenshaw's recurrence.
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

Colour viridis(double t) {
  return {to_byte(evaluate(kViridisRed, t)), to_byte(evaluate(kViridisGreen, t)),
          to_byte(evaluate(kViridisBlue, t))};
}

Colour blue_white_red(double t) {
  return t < 0.5 ? mixed(kColdest, kWhite, 2.0 * t) : mixed(kWhite, kHottest, 2.0 * t - 1.0);
}

/// Returns a colour of the "jet" palette. Each channel is a trapezium half a palette wide; the red
/// one comes a quarter after the green one, the blue one a quarter before it.
Colour jet(double t) {
  return {to_byte(1.5 - std::abs(4.0 * t - 3.0)), to_byte(1.5 - std::abs(4.0 * t - 2.0)),
          to_byte(1.5 - std::abs(4.0 * t - 1.0))};
}

/// Returns a colour of the "hot" palette, in which red, green and blue rise one after the other.
Colour hot(double t) {
  return {to_byte(t / 0.375), to_byte((t - 0.375) / 0.375), to_byte((t - 0.75) / 0.25)};
}

/// Returns the saturated colour of a hue from 0 to 1: red, yellow, green, cyan, blue, magenta and
/// red again.
Colour full_colour(double hue) {
  return {to_byte(std::abs(6.0 * hue - 3.0) - 1.0), to_byte(2.0 - std::abs(6.0 * hue - 2.0)),
          to_byte(2.0 - std::abs(6.0 * hue - 4.0))};
}

/// Returns a colour whose hue is a golden section of the circle away from the previous one, so that
/// hues spread evenly however many there are; pale, saturated and dark colours alternate.
Colour further_colour(std::size_t k) {
  constexpr double kGoldenSection = std::numbers::phi - 1.0;
  const double turns = kGoldenSection * static_cast<double>(k);
  const Colour full = full_colour(turns - std::floor(turns));
  return k % 3 == 0 ? mixed(full, kWhite, 0.5) : k % 3 == 1 ? full : mixed(full, kBlack, 0.4);
}

/// A palette, its name, and its colours from 0 to 1.
struct PaletteRow {
  Palette palette;
  std::string_view name;
  Colour (*colour_at)(double t);
};

constexpr std::array kPaletteRows{PaletteRow{Palette::Sequential, "viridis", viridis},
                                  PaletteRow{Palette::Diverging, "diverging", blue_white_red},
                                  PaletteRow{Palette::Jet, "jet", jet},
                                  PaletteRow{Palette::Hot, "hot", hot}};

constexpr std::array kPalettes = [] {
  std::array<Palette, kPaletteRows.size()> palettes{};
  for (std::size_t i = 0; i < palettes.size(); ++i) palettes[i] = kPaletteRows[i].palette;
  return palettes;
}();

const PaletteRow& row_of(Palette palette) {
  return *std::find_if(kPaletteRows.begin(), kPaletteRows.end(),
                       [&](const PaletteRow& row) { return row.palette == palette; });
}

}  // namespace

std::span<const Palette> all_palettes() {
  return kPalettes;
}

std::string_view palette_name(Palette palette) {
  return row_of(palette).name;
}

std::optional<Palette> palette_of(std::string_view name) {
  return find_named(kPalettes, name, palette_name);
}

Colour colour_of(Palette palette, double t) {
  return std::isnan(t) ? kNoValueColour : row_of(palette).colour_at(std::clamp(t, 0.0, 1.0));
}

Colour category_colour(std::size_t k) {
  k %= kCategoryColours;
  return k < kDistinct.size() ? kDistinct[k] : further_colour(k);
}

Colour ColourScale::colour_of(double value) const {
  // Halves are subtracted, because max - min may overflow.
  const double range = max / 2.0 - min / 2.0;
  const double place = value / 2.0 - min / 2.0;
  const double t = range > 0.0 ? place / range : std::isnan(value) ? value : 0.5;
  return meshalyzer::colour_of(palette, t);
}

std::optional<std::pair<double, double>> finite_range(std::span<const double> values) {
  std::optional<std::pair<double, double>> range;
  for (const double value : values) {
    if (std::isfinite(value)) {
      range = range ? std::pair(std::min(range->first, value), std::max(range->second, value))
                    : std::pair(value, value);
    }
  }
  return range;
}

ColourScale scale_for(std::span<const double> values) {
  const std::optional<std::pair<double, double>> range = finite_range(values);
  if (!range) {
    return {};
  }
  const auto [min, max] = *range;
  if (min < 0.0 && 0.0 < max) {
    const double largest = std::max(-min, max);
    return {Palette::Diverging, -largest, largest};
  }
  return {Palette::Sequential, min, max};
}

}  // namespace meshalyzer
