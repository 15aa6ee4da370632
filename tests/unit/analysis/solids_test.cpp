#include "meshalyzer/analysis/analyze.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>

namespace meshalyzer {
namespace {

using shapes::InnerShell;

std::optional<bool> outward(const Soup& soup) {
  return analyze(soup, "soup").attributes.outward.value;
}

TEST(AnalyzeSolids, LoneShellIsOutwardUnlessInsideOut) {
  EXPECT_EQ(outward(shapes::cube()), true);
  EXPECT_EQ(outward(shapes::flipped(shapes::cube())), false);
}

TEST(AnalyzeSolids, InwardCubeHasNegativeVolume) {
  const Analysis analysis = analyze(shapes::flipped(shapes::cube(2.0)), "inward");
  EXPECT_NEAR(analysis.characteristics.volume.value.value(), -8.0, 1e-14);
  EXPECT_EQ(analysis.components.at(0).outward, false);
}

TEST(AnalyzeSolids, WallOfACavityPointsIntoIt) {
  const Analysis analysis = analyze(shapes::nested_cubes(InnerShell::Cavity), "cavity");
  EXPECT_EQ(analysis.attributes.outward.value, true);
  EXPECT_NEAR(analysis.characteristics.volume.value.value(), 26.0, 1e-13);
  EXPECT_EQ(analysis.components.at(1).outward, true);
  EXPECT_NEAR(analysis.components.at(1).volume.value(), -1.0, 1e-14);
  EXPECT_FALSE(analysis.components.at(0).inside.has_value());
  EXPECT_EQ(analysis.components.at(1).inside, 0U);
}

TEST(AnalyzeSolids, OutwardShellWithinAnotherIsTurned) {
  const Analysis analysis = analyze(shapes::nested_cubes(InnerShell::Outward), "inside out");
  EXPECT_EQ(analysis.attributes.outward.value, false);
  EXPECT_EQ(analysis.components.at(0).outward, true);
  EXPECT_EQ(analysis.components.at(1).outward, false);
  EXPECT_NEAR(analysis.characteristics.volume.value.value(), 28.0, 1e-13);
}

TEST(AnalyzeSolids, ShellsAlternateHoweverDeeplyTheyLie) {
  // Sides 9, 7, 5, 3, 1 about one centre, every other one turned.
  Soup soup;
  for (int depth = 0; depth < 5; ++depth) {
    const Soup shell = shapes::cube(9.0 - 2 * depth, Vec3::Constant(depth));
    soup = shapes::merged(soup, depth % 2 == 0 ? shell : shapes::flipped(shell));
  }
  const Analysis analysis = analyze(soup, "shells");
  EXPECT_EQ(analysis.attributes.outward.value, true);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_EQ(analysis.components.at(i).inside, i - 1);
  EXPECT_EQ(outward(shapes::flipped(soup)), false);
}

TEST(AnalyzeSolids, OrderOfShellsInTheFileIsNoMatter) {
  const Soup soup =
      shapes::merged(shapes::flipped(shapes::cube(1.0, {1, 1, 1})), shapes::cube(3.0));
  const Analysis analysis = analyze(soup, "cavity");
  EXPECT_EQ(analysis.attributes.outward.value, true);
  EXPECT_EQ(analysis.components.at(0).inside, 1U);
}

TEST(AnalyzeSolids, CrossingCubesAreBothOutward) {
  const Analysis analysis =
      analyze(shapes::merged(shapes::cube(), shapes::cube(1.0, {0.5, 0.25, 0.125})), "crossing");
  EXPECT_EQ(analysis.attributes.outward.value, true);
  EXPECT_GT(analysis.characteristics.intersecting_pairs, 0U);
  EXPECT_EQ(analysis.components.at(0).intersecting_pairs,
            analysis.characteristics.intersecting_pairs);
  EXPECT_FALSE(analysis.components.at(0).inside.has_value());
  EXPECT_FALSE(analysis.components.at(1).inside.has_value());
}

TEST(AnalyzeSolids, CubeInTheHoleOfATorusIsOutsideIt) {
  const Soup ring = shapes::torus(3, 1, 16, 8);
  const Soup small = shapes::cube(0.5, Vec3::Constant(-0.25));
  EXPECT_EQ(outward(shapes::merged(ring, small)), true);
  EXPECT_EQ(outward(shapes::merged(ring, shapes::flipped(small))), false);
  // In the tube it would be a cavity.
  const Soup in_tube = shapes::translated(small, {3, 0, 0});
  EXPECT_EQ(outward(shapes::merged(ring, in_tube)), false);
  EXPECT_EQ(outward(shapes::merged(ring, shapes::flipped(in_tube))), true);
}

TEST(AnalyzeSolids, BarAcrossAHoleIsNotInsideThoughItsCornersAre) {
  // A block of 3 x 3 x 1 with a hole in its middle; the bar leaves it in the hole and enters again.
  // One end of the bar lies in the side of the block, so that faces touch as well as cross.
  Soup bar = shapes::cube();
  for (Vec3& p : bar.positions) p = Vec3(2.5 * p.x(), 1.25 + 0.5 * p.y(), 0.25 + 0.5 * p.z());
  for (const Soup& soup :
       {shapes::merged(shapes::genus_block(1), bar), shapes::merged(bar, shapes::genus_block(1))}) {
    const Analysis analysis = analyze(soup, "bar");
    EXPECT_EQ(analysis.attributes.outward.value, true);
    EXPECT_FALSE(analysis.components.at(0).inside.has_value());
    EXPECT_FALSE(analysis.components.at(1).inside.has_value());
  }
}

TEST(AnalyzeSolids, OpenShellEnclosesNothing) {
  const Soup soup = shapes::merged(
      shapes::cube(1.0, {0.25, 0.25, 0.25}),
      shapes::translated(shapes::scaled(shapes::open_cube(), 3.0), Vec3::Constant(-1.0)));
  const Analysis analysis = analyze(soup, "in a box");
  EXPECT_EQ(analysis.components.at(0).outward, true);
  EXPECT_FALSE(analysis.components.at(0).inside.has_value());
}

TEST(AnalyzeSolids, ShellOneBitThickIsDecided) {
  // A tetrahedron whose apex is one bit above or below its base: volume 1e-17.
  const auto sheet = [](double apex) {
    Soup soup = shapes::tetrahedron();
    for (Vec3& p : soup.positions) p.z() = 0.1;
    soup.positions[3] = {0.25, 0.25, apex};
    return soup;
  };
  EXPECT_EQ(outward(sheet(std::nextafter(0.1, 1.0))), true);
  EXPECT_EQ(outward(sheet(std::nextafter(0.1, 0.0))), false);
  EXPECT_EQ(outward(sheet(0.1)), std::nullopt);
}

}  // namespace
}  // namespace meshalyzer
