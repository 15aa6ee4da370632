#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace meshalyzer {

/// An sRGB colour, 0 ... 255 a channel.
struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend bool operator==(const Colour&, const Colour&) = default;
};

/// Grey: that of places without a value; in no palette.
inline constexpr Colour kNoValueColour{128, 128, 128};

/// A run of colours.
enum class Palette : std::uint8_t {
  /// Viridis: dark blue over green to yellow, evenly and ever lighter, also in print and for eyes
  /// that do not tell red from green.
  Sequential,
  /// Blue over white to red: for values below and above something in the middle.
  Diverging,
  /// Dark blue over cyan, yellow and red to dark red, as MATLAB's map of this name: looks of old
  /// reports. Neither even nor for all eyes.
  Jet,
  /// Black over red and yellow to white, as MATLAB's map of this name.
  Hot,
};

/// "viridis", "diverging", "jet", "hot".
[[nodiscard]] std::string_view palette_name(Palette palette);
/// Returns the palette of a name; nothing where there is none of that name.
[[nodiscard]] std::optional<Palette> palette_of(std::string_view name);

/// Returns the colour at a place in a palette.
/// @param t  0 is its beginning, 1 its end; what is beyond has the colour of the end that is
///           nearer, NaN kNoValueColour.
[[nodiscard]] Colour colour_of(Palette palette, double t);

/// The number of colours that are easily told apart from each other, from white, black and grey,
/// also by colour-blind people.
inline constexpr std::size_t kDistinctCategories = 15;
/// The colours of categories repeat after so many; until then no two are the same.
inline constexpr std::size_t kCategoryColours = 256;

/// Returns the colour of the k-th of several things that have no order; never kNoValueColour.
[[nodiscard]] Colour category_colour(std::size_t k);

/// Colours for the values of a field.
struct ColourScale {
  Palette palette = Palette::Sequential;
  /// The values at the beginning and the end of the palette; finite, min <= max.
  double min = 0.0;
  double max = 0.0;

  /// Returns the colour of a value. Where min and max are the same, all values have the middle
  /// colour.
  [[nodiscard]] Colour colour_of(double value) const;
};

/// Returns the smallest and the largest of the finite values; nothing where none is.
[[nodiscard]] std::optional<std::pair<double, double>> finite_range(std::span<const double> values);

/// Returns the scale that shows a field best: where values of both signs occur white is 0 and a
/// length in blue is the same as in red; else from the smallest to the largest value.
/// @param values  Those that are not finite do not matter; 0 ... 0 where none is.
[[nodiscard]] ColourScale scale_for(std::span<const double> values);

}  // namespace meshalyzer
