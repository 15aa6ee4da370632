#include "meshalyzer/base/colour_map.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <vector>

namespace meshalyzer {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void expect_near(const Colour& colour, const Colour& expected) {
  EXPECT_LE(std::abs(colour.red - expected.red), 1);
  EXPECT_LE(std::abs(colour.green - expected.green), 1);
  EXPECT_LE(std::abs(colour.blue - expected.blue), 1);
}

TEST(ColourOf, SequentialIsViridisToOneStep) {
  const auto entry = [](int i) { return colour_of(Palette::Sequential, i / 255.0); };
  // Entries of the published table of 256, times 255.
  expect_near(entry(0), {68, 1, 84});
  expect_near(entry(14), {72, 22, 104});    // 0.281446 0.084320 0.407414
  expect_near(entry(92), {46, 111, 142});   // 0.179019 0.433756 0.557430
  expect_near(entry(143), {31, 159, 136});  // 0.120081 0.622161 0.534946
  expect_near(entry(237), {208, 225, 28});  // 0.814576 0.883393 0.110347
  expect_near(entry(247), {234, 229, 26});  // 0.916242 0.896091 0.100717
  expect_near(entry(255), {253, 231, 37});
}

TEST(ColourOf, DivergingIsBlueThenWhiteThenRed) {
  const Colour low = colour_of(Palette::Diverging, 0.0);
  const Colour high = colour_of(Palette::Diverging, 1.0);
  EXPECT_GT(low.blue, low.red);
  EXPECT_GT(high.red, high.blue);
  EXPECT_EQ(colour_of(Palette::Diverging, 0.5), (Colour{255, 255, 255}));
}

TEST(ColourOf, WhatIsBeyondAnEndHasItsColour) {
  for (const Palette palette : {Palette::Sequential, Palette::Diverging}) {
    EXPECT_EQ(colour_of(palette, -kInfinity), colour_of(palette, 0.0));
    EXPECT_EQ(colour_of(palette, 1.5), colour_of(palette, 1.0));
  }
}

TEST(ColourOf, NoValueIsGreyAndNoValueElseIs) {
  for (const Palette palette : {Palette::Sequential, Palette::Diverging}) {
    EXPECT_EQ(colour_of(palette, kNaN), kNoValueColour);
    for (int i = 0; i <= 1000; ++i) {
      EXPECT_NE(colour_of(palette, i / 1000.0), kNoValueColour);
    }
  }
}

TEST(ScaleFor, ValuesOfOneSignGoFromTheSmallestToTheLargest) {
  const std::vector<double> values{3, kNaN, 1, kInfinity, 2};
  const ColourScale scale = scale_for(values);
  EXPECT_EQ(scale.palette, Palette::Sequential);
  EXPECT_EQ(scale.min, 1);
  EXPECT_EQ(scale.max, 3);
  EXPECT_EQ(scale.colour_of(2), colour_of(Palette::Sequential, 0.5));
}

TEST(ScaleFor, ValuesOfBothSignsHaveNoughtInTheMiddle) {
  const std::vector<double> values{-1, 4};
  const ColourScale scale = scale_for(values);
  EXPECT_EQ(scale.colour_of(0), (Colour{255, 255, 255}));
  EXPECT_EQ(scale.colour_of(4), colour_of(Palette::Diverging, 1.0));
  EXPECT_EQ(scale.colour_of(-1), colour_of(Palette::Diverging, 0.375));  // (-1 + 4) / 8
}

TEST(ScaleFor, NoughtAmongNegativeValuesIsNotASecondSign) {
  const std::vector<double> values{-2, 0};
  EXPECT_EQ(scale_for(values).palette, Palette::Sequential);
}

TEST(ScaleFor, EqualValuesHaveTheColourOfTheMiddle) {
  const std::vector<double> values{7, 7};
  EXPECT_EQ(scale_for(values).colour_of(7), colour_of(Palette::Sequential, 0.5));
  EXPECT_EQ(scale_for(values).colour_of(kNaN), kNoValueColour);
}

TEST(ScaleFor, NoValuesAreNoTrouble) {
  EXPECT_EQ(scale_for({}).colour_of(kNaN), kNoValueColour);
}

TEST(ScaleFor, RangeBeyondTheLargestDoubleStillHasAMiddle) {
  constexpr double kMax = std::numeric_limits<double>::max();
  const std::vector<double> values{-kMax, kMax};
  EXPECT_EQ(scale_for(values).colour_of(0), (Colour{255, 255, 255}));
}

}  // namespace
}  // namespace meshalyzer
