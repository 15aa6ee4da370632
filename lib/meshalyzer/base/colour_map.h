#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace meshalyzer {

/// An sRGB colour with channels from 0 to 255.
struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend bool operator==(const Colour&, const Colour&) = default;
};

/// The grey of places without a value; no palette contains it.
inline constexpr Colour kNoValueColour{128, 128, 128};

/// A continuous range of colours.
enum class Palette : std::uint8_t {
  /// Viridis: from dark blue over green to yellow, perceptually even and ever lighter, which also
  /// holds in print and for red-green colour-blind people.
  Sequential,
  /// Blue over white to red, for values on both sides of a middle.
  Diverging,
  /// Dark blue over cyan, yellow and red to dark red, as MATLAB's map of this name, for comparison
  /// with old reports. It is neither perceptually even nor suitable for colour-blind people.
  Jet,
  /// Black over red and yellow to white, as MATLAB's map of this name.
  Hot,
};

/// Returns all palettes, in the order of Palette.
[[nodiscard]] std::span<const Palette> all_palettes();

/// Returns the name of a palette as in "viridis", "diverging", "jet", "hot".
[[nodiscard]] std::string_view palette_name(Palette palette);
/// Returns the palette with the given name, or nothing when no palette has it.
[[nodiscard]] std::optional<Palette> palette_of(std::string_view name);

/// Returns the colour at a place in a palette.
/// @param t  0 is its beginning, 1 its end. Values outside get the colour of the nearer end, NaN
///           gets kNoValueColour.
[[nodiscard]] Colour colour_of(Palette palette, double t);

/// The number of category colours that even colour-blind people easily tell apart from each other
/// and from white, black and grey.
inline constexpr std::size_t kDistinctCategories = 15;
/// The number of different category colours; after it they repeat.
inline constexpr std::size_t kCategoryColours = 256;

/// Returns the colour of the k-th of several things that have no order; never kNoValueColour.
[[nodiscard]] Colour category_colour(std::size_t k);

/// Maps the values of a field to colours.
struct ColourScale {
  Palette palette = Palette::Sequential;
  /// The values at the beginning and the end of the palette; finite, min <= max.
  double min = 0.0;
  double max = 0.0;

  /// Returns the colour of a value. Where min and max are the same, all values have the middle
  /// colour.
  [[nodiscard]] Colour colour_of(double value) const;
};

/// Returns the smallest and the largest of the finite values, or nothing when there is no finite
/// value.
[[nodiscard]] std::optional<std::pair<double, double>> finite_range(std::span<const double> values);

/// Returns the scale that shows a field best. Where values of both signs occur, it is diverging,
/// symmetric about 0, which is white; otherwise it runs from the smallest to the largest value.
/// @param values  Values that are not finite are ignored; without any finite value the scale is 0
///                ... 0.
[[nodiscard]] ColourScale scale_for(std::span<const double> values);

}  // namespace meshalyzer
