#include "meshalyzer/base/colour_map.h"

#include "support/constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace meshalyzer {
namespace {

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

TEST(ColourOf, JetIsThatOfTheLaboratory) {
  // Half intensity is 127.5, which is rounded up.
  EXPECT_EQ(colour_of(Palette::Jet, 0.0), (Colour{0, 0, 128}));
  EXPECT_EQ(colour_of(Palette::Jet, 0.125), (Colour{0, 0, 255}));
  EXPECT_EQ(colour_of(Palette::Jet, 0.375), (Colour{0, 255, 255}));
  EXPECT_EQ(colour_of(Palette::Jet, 0.5), (Colour{128, 255, 128}));
  EXPECT_EQ(colour_of(Palette::Jet, 0.625), (Colour{255, 255, 0}));
  EXPECT_EQ(colour_of(Palette::Jet, 0.875), (Colour{255, 0, 0}));
  EXPECT_EQ(colour_of(Palette::Jet, 1.0), (Colour{128, 0, 0}));
}

TEST(ColourOf, HotIsBlackThenRedThenYellowThenWhite) {
  EXPECT_EQ(colour_of(Palette::Hot, 0.0), (Colour{0, 0, 0}));
  EXPECT_EQ(colour_of(Palette::Hot, 0.375), (Colour{255, 0, 0}));
  EXPECT_EQ(colour_of(Palette::Hot, 0.5625), (Colour{255, 128, 0}));  // halfway to yellow
  EXPECT_EQ(colour_of(Palette::Hot, 0.75), (Colour{255, 255, 0}));
  EXPECT_EQ(colour_of(Palette::Hot, 1.0), (Colour{255, 255, 255}));
}

TEST(PaletteOf, UndoesPaletteName) {
  for (const Palette palette : all_palettes()) {
    EXPECT_EQ(palette_of(palette_name(palette)), palette);
  }
  EXPECT_EQ(palette_of("viridis"), Palette::Sequential);
  EXPECT_EQ(palette_of("diverging"), Palette::Diverging);
  EXPECT_EQ(palette_of("jet"), Palette::Jet);
  EXPECT_EQ(palette_of("hot"), Palette::Hot);
  EXPECT_EQ(palette_of("Jet"), std::nullopt);
  EXPECT_EQ(palette_of(""), std::nullopt);
}

TEST(ColourOf, WhatIsBeyondAnEndHasItsColour) {
  for (const Palette palette : all_palettes()) {
    EXPECT_EQ(colour_of(palette, -kInfinity), colour_of(palette, 0.0));
    EXPECT_EQ(colour_of(palette, 1.5), colour_of(palette, 1.0));
  }
}

TEST(ColourOf, NoValueIsGreyAndNoValueElseIs) {
  for (const Palette palette : all_palettes()) {
    EXPECT_EQ(colour_of(palette, kNaN), kNoValueColour);
    for (int i = 0; i <= 1000; ++i) {
      EXPECT_NE(colour_of(palette, i / 1000.0), kNoValueColour);
    }
  }
}

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple product(const Matrix& matrix, const Triple& vector) {
  Triple result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result[i] += matrix[i][j] * vector[j];
    }
  }
  return result;
}

Triple linear(const Colour& colour) {
  const auto channel = [](int byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return {channel(colour.red), channel(colour.green), channel(colour.blue)};
}

/// Converts from linear sRGB (Ottosson 2020).
Triple oklab(const Triple& rgb) {
  constexpr Matrix kCones{{{0.4122214708, 0.5363325363, 0.0514459929},
                           {0.2119034982, 0.6806995451, 0.1073969566},
                           {0.0883024619, 0.2817188376, 0.6299787005}}};
  constexpr Matrix kLab{{{0.2104542553, 0.7936177850, -0.0040720468},
                         {1.9779984951, -2.4285922050, 0.4505937099},
                         {0.0259040371, 0.7827717662, -0.8086757660}}};
  Triple cones = product(kCones, rgb);
  for (double& cone : cones) {
    cone = std::cbrt(cone);
  }
  return product(kLab, cones);
}

/// What an eye makes of linear sRGB (Machado, Oliveira and Fernandes 2009, severity 1), and how far
/// apart colours are to be for it; just noticeable is about 0.02.
struct Eye {
  Matrix matrix;
  double enough;
};

constexpr std::array kEyes{
    Eye{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 0.15},
    Eye{{{{0.152286, 1.052583, -0.204868},
          {0.114503, 0.786281, 0.099216},
          {-0.003882, -0.048116, 1.051998}}},
        0.08},
    Eye{{{{0.367322, 0.860646, -0.227968},
          {0.280085, 0.672501, 0.047413},
          {-0.011820, 0.042940, 0.968881}}},
        0.08},
    Eye{{{{1.255528, -0.076749, -0.178779},
          {-0.078411, 0.930809, 0.147602},
          {0.004733, 0.691367, 0.303900}}},
        0.07},
};

double distance(const Colour& a, const Colour& b, const Eye& eye) {
  const auto seen = [&](const Colour& colour) {
    Triple rgb = product(eye.matrix, linear(colour));
    for (double& channel : rgb) {
      channel = std::clamp(channel, 0.0, 1.0);
    }
    return oklab(rgb);
  };
  const Triple p = seen(a);
  const Triple q = seen(b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

TEST(CategoryColour, FirstOnesAreToldApartByAllEyesAndOnAllGrounds) {
  std::vector<Colour> all{{255, 255, 255}, {0, 0, 0}, kNoValueColour};
  for (std::size_t k = 0; k < kDistinctCategories; ++k) {
    const Colour colour = category_colour(k);
    for (const Colour& other : all) {
      for (const Eye& eye : kEyes) {
        EXPECT_GE(distance(colour, other, eye), eye.enough) << k;
      }
    }
    all.push_back(colour);
  }
}

TEST(CategoryColour, NoTwoAreTheSameUntilTheyRepeat) {
  std::vector<Colour> all{kNoValueColour};
  for (std::size_t k = 0; k < kCategoryColours; ++k) {
    const Colour colour = category_colour(k);
    EXPECT_EQ(std::count(all.begin(), all.end(), colour), 0) << k;
    EXPECT_EQ(category_colour(k + kCategoryColours), colour);
    all.push_back(colour);
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
