#include "meshalyzer/picture/field.h"
#include "support/constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace meshalyzer {
namespace {

constexpr double kMax = std::numeric_limits<double>::max();

Field magnitudes(std::vector<double> values) {
  return {FieldName::Area, FieldPlace::Faces, FieldKind::Magnitude, std::move(values)};
}

Field signed_values(std::vector<double> values) {
  return {FieldName::Mean, FieldPlace::Vertices, FieldKind::Signed, std::move(values)};
}

Field categories(FieldName name, std::vector<double> values) {
  return {name, FieldPlace::Faces, FieldKind::Category, std::move(values)};
}

void expect_range(const ColourScale& scale, double min, double max) {
  EXPECT_EQ(scale.min, min);
  EXPECT_EQ(scale.max, max);
}

/// The smallest value that at least p percent of all do not exceed, by counting.
double percentile(const std::vector<double>& values, std::size_t p) {
  double result = kInfinity;
  for (const double candidate : values) {
    const auto n = static_cast<std::size_t>(std::count_if(
        values.begin(), values.end(), [&](double value) { return value <= candidate; }));
    if (100 * n >= p * values.size()) {
      result = std::min(result, candidate);
    }
  }
  return result;
}

TEST(ScaleOf, MagnitudesGoFromPercentileToPercentile) {
  std::mt19937 random(1);
  for (std::size_t n = 2; n < 260; ++n) {
    std::vector<double> values;
    for (std::size_t i = 0; i < n; ++i) {
      values.push_back(static_cast<double>(random()) / 7.0);
    }
    const double low = percentile(values, 2);
    const double high = percentile(values, 98);
    values.insert(values.begin(), {kNaN, kInfinity});
    values.push_back(-kInfinity);
    const ColourScale scale = scale_of(magnitudes(values));
    EXPECT_EQ(scale.palette, Palette::Sequential);
    expect_range(scale, low, high);
  }
}

TEST(ScaleOf, OutliersDoNotTakeAllColours) {
  std::vector<double> values(100, 1.0);
  values[3] = 1e6;
  std::fill_n(values.begin() + 10, 50, 2.0);
  expect_range(scale_of(magnitudes(values)), 1.0, 2.0);
}

TEST(ScaleOf, FewDifferentValuesAreShownWhereAllElseIsTheSame) {
  std::vector<double> values(1000, 4.0);
  values[7] = 3.0;
  values[8] = 9.0;
  expect_range(scale_of(magnitudes(values)), 3.0, 9.0);
}

TEST(ScaleOf, RoundingIsNotShownAsValues) {
  std::vector<double> values(1000, 0.0);
  for (std::size_t i = 0; i < values.size(); i += 2) {
    values[i] = 1e-15;
  }
  values[7] = -1.0;
  values[8] = 2.0;
  expect_range(scale_of(signed_values(values)), -2.0, 2.0);
}

TEST(ScaleOf, SignedValuesAreSymmetricAboutNought) {
  std::vector<double> values;
  for (int i = -50; i <= 149; ++i) {
    values.push_back(i);
  }
  // The 196th smallest of 200 values is 145, the 4th -47.
  const ColourScale scale = scale_of(signed_values(values));
  EXPECT_EQ(scale.palette, Palette::Diverging);
  expect_range(scale, -145, 145);
  EXPECT_EQ(scale.colour_of(0), (Colour{255, 255, 255}));
  for (double& value : values) {
    value = -value;
  }
  // Now the 196th smallest is 46, the 4th -146.
  expect_range(scale_of(signed_values(values)), -146, 146);
}

TEST(ScaleOf, SignedValuesOfOneSignAreStillSymmetric) {
  const ColourScale scale = scale_of(signed_values({2, 2, 2}));
  EXPECT_EQ(scale.palette, Palette::Diverging);
  expect_range(scale, -2, 2);
}

TEST(ScaleOf, NoFiniteValueIsNoughtToNought) {
  expect_range(scale_of(magnitudes({})), 0, 0);
  expect_range(scale_of(magnitudes({kNaN, kInfinity})), 0, 0);
  expect_range(scale_of(signed_values({kNaN})), 0, 0);
}

TEST(ScaleOf, RangeBeyondTheLargestDoubleIsStillARange) {
  expect_range(scale_of(signed_values({-kMax, kMax})), -kMax, kMax);
  expect_range(scale_of(magnitudes({-kMax, kMax})), -kMax, kMax);
}

TEST(ScaleOf, CategoriesGoFromTheSmallestToTheLargest) {
  std::vector<double> values(1000, 1.0);
  values[5] = 0.0;
  values[6] = 7.0;
  expect_range(scale_of(categories(FieldName::Component, values)), 0, 7);
}

TEST(ColoursOf, ValuesRunAlongTheScale) {
  const Field field = magnitudes({1, 3});
  const FieldColours colours = colours_of(field);
  ASSERT_TRUE(colours.scale);
  expect_range(*colours.scale, 1, 3);
  EXPECT_EQ(colours.of(2), colour_of(Palette::Sequential, 0.5));
  EXPECT_EQ(colours.of(kInfinity), colour_of(Palette::Sequential, 1.0));
  EXPECT_EQ(colours.of(kNaN), kNoValueColour);
}

TEST(ColoursOf, PaletteAskedForKeepsTheRange) {
  const FieldColours colours = colours_of(signed_values({-1, 3}), Palette::Jet);
  ASSERT_TRUE(colours.scale);
  EXPECT_EQ(colours.scale->palette, Palette::Jet);
  expect_range(*colours.scale, -3, 3);
}

TEST(ColoursOf, ComponentsHaveAColourEach) {
  const FieldColours colours = colours_of(categories(FieldName::Component, {0, 1, 2}));
  EXPECT_FALSE(colours.scale);
  EXPECT_EQ(colours.of(0), category_colour(0));
  EXPECT_EQ(colours.of(2), category_colour(2));
  EXPECT_EQ(colours.of(kNaN), kNoValueColour);
}

TEST(ColoursOf, DefectsHaveTheColourOfTheirCodeAndNoneIsPale) {
  const FieldColours colours = colours_of(categories(FieldName::Defect, {0, 1, 2}));
  EXPECT_EQ(colours.of(0), kNoDefectColour);
  EXPECT_EQ(colours.of(1), category_colour(0));
  EXPECT_EQ(colours.of(15), category_colour(14));
  EXPECT_NE(kNoDefectColour, kNoValueColour);
  for (std::size_t k = 0; k < kCategoryColours; ++k) {
    EXPECT_NE(category_colour(k), kNoDefectColour);
  }
}

TEST(ColoursOf, CategoriesRunAlongAPaletteWhereOneIsAskedFor) {
  const FieldColours colours =
      colours_of(categories(FieldName::Component, {0, 1, 2}), Palette::Hot);
  EXPECT_EQ(colours.of(1), colour_of(Palette::Hot, 0.5));
}

}  // namespace
}  // namespace meshalyzer
