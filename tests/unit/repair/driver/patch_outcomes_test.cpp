#include "meshalyzer/repair/fix_defects.h"
#include "support/shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace meshalyzer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<PatchOutcome> outcomes_of(const Soup& soup) {
  RepairOptions options;
  options.reports_patches = true;
  options.max_deviation = {.value = 0.01, .unit = Deviation::Unit::Length};
  return fix_defects(soup, options).patches;
}

/// A block of width 1 and height 0.5 whose top is pushed down in its middle, through the bottom and
/// `depth` beyond.
Soup pushed_through(double depth) {
  return shapes::make({{-0.5, -0.5, 0},
                       {0.5, -0.5, 0},
                       {0.5, 0.5, 0},
                       {-0.5, 0.5, 0},
                       {-0.5, -0.5, 0.5},
                       {0.5, -0.5, 0.5},
                       {0.5, 0.5, 0.5},
                       {-0.5, 0.5, 0.5},
                       {0, 0, -depth}},
                      {{0, 2, 1},
                       {0, 3, 2},
                       {0, 1, 5},
                       {0, 5, 4},
                       {1, 2, 6},
                       {1, 6, 5},
                       {2, 3, 7},
                       {2, 7, 6},
                       {3, 0, 4},
                       {3, 4, 7},
                       {4, 5, 8},
                       {5, 6, 8},
                       {6, 7, 8},
                       {7, 4, 8}});
}

/// How far the tip is from what stays when it is cut off: its sides rise from -depth to 0.5 over a
/// width of 0.5, so that they pass the bottom so far from its middle.
double distance_of_tip(double depth) {
  return std::hypot(depth, 0.5 * depth / (0.5 + depth));
}

Soup crossing_cubes() {
  return shapes::merged(shapes::cube(), shapes::cube(1, {0.5, 0.25, 0.125}));
}

Soup crossing_faces() {
  return shapes::make({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {-3, 1, 0}},
                      {{0, 1, 2}, {3, 4, 5}});
}

TEST(PatchOutcomes, SolidsAreCutAndLooseFacesAreLeftForAReason) {
  const std::vector<PatchOutcome> outcomes = outcomes_of(
      shapes::merged(crossing_cubes(), shapes::translated(crossing_faces(), {9, 0, 0})));
  ASSERT_EQ(outcomes.size(), 2U);
  EXPECT_TRUE(outcomes[0].is_mended);
  EXPECT_THAT(outcomes[0].passes, ElementsAre("cut intersections"));
  EXPECT_LT(outcomes[0].distance, 1e-15);
  EXPECT_EQ(outcomes[0].reason, "");
  EXPECT_FALSE(outcomes[1].is_mended);
  EXPECT_THAT(outcomes[1].passes, ElementsAre());
  EXPECT_EQ(outcomes[1].distance, 0.0);
  EXPECT_THAT(outcomes[1].reason, HasSubstr("loose"));
}

TEST(PatchOutcomes, DistanceIsThatOfThePatchAlone) {
  const double small = 1e-3;
  const double large = 4e-3;
  const std::vector<PatchOutcome> outcomes = outcomes_of(
      shapes::merged(pushed_through(large), shapes::translated(pushed_through(small), {9, 0, 0})));
  ASSERT_EQ(outcomes.size(), 2U);
  // Measured to a thousandth of the maximum deviation.
  const double resolution = 1e-5;
  EXPECT_NEAR(outcomes[0].distance, distance_of_tip(large), resolution);
  EXPECT_NEAR(outcomes[1].distance, distance_of_tip(small), resolution);
  EXPECT_TRUE(outcomes[0].is_mended && outcomes[1].is_mended);
}

TEST(PatchOutcomes, PlaceOfThePatchIsThatAmongAllDefects) {
  RepairOptions options;
  options.reports_patches = true;
  const RepairResult result = fix_defects(crossing_cubes(), options);
  ASSERT_EQ(result.patches.size(), 1U);
  EXPECT_EQ(result.before.defects[result.patches.front().defect].code,
            DefectCode::SelfIntersection);
}

TEST(PatchOutcomes, NoneAreToldUnlessAskedForOrWhereNothingIntersects) {
  EXPECT_TRUE(fix_defects(crossing_cubes()).patches.empty());
  EXPECT_TRUE(outcomes_of(shapes::cube()).empty());
}

}  // namespace
}  // namespace meshalyzer
