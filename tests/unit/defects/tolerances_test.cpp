#include "meshalyzer/defects/tolerances.h"

#include "meshalyzer/base/error.h"
#include "support/constants.h"

#include <gtest/gtest.h>

#include <cmath>

namespace meshalyzer {
namespace {

/// With a diagonal of 13: 3^2 + 4^2 + 12^2 = 13^2.
Box3 box_of_diagonal_thirteen() {
  return {Vec3(-1, 1, 2), Vec3(2, 5, 14)};
}

TEST(ResolveTolerances, DefaultIsAShareOfTheDiagonal) {
  const Tolerances tolerances = resolve_tolerances({}, box_of_diagonal_thirteen());
  EXPECT_DOUBLE_EQ(tolerances.degeneracy, 13e-8);
  EXPECT_DOUBLE_EQ(tolerances.slit, 13e-8);
  EXPECT_DOUBLE_EQ(tolerances.height, 13e-8);
  EXPECT_EQ(tolerances.max_foldover_angle, 1.0);
}

TEST(ResolveTolerances, OneToleranceIsForAllThree) {
  const Tolerances tolerances = resolve_tolerances({.tolerance = 0.5}, box_of_diagonal_thirteen());
  EXPECT_EQ(tolerances.degeneracy, 0.5);
  EXPECT_EQ(tolerances.slit, 0.5);
  EXPECT_EQ(tolerances.height, 0.5);
}

TEST(ResolveTolerances, WhatIsSaidOfOneCountsMoreThanWhatIsSaidOfAll) {
  const ToleranceOptions options{
      .tolerance = 0.5, .degeneracy = 0.0, .slit = 2.0, .max_foldover_angle = 3.0};
  const Tolerances tolerances = resolve_tolerances(options, box_of_diagonal_thirteen());
  EXPECT_EQ(tolerances.degeneracy, 0.0);
  EXPECT_EQ(tolerances.slit, 2.0);
  EXPECT_EQ(tolerances.height, 0.5);
  EXPECT_EQ(tolerances.max_foldover_angle, 3.0);
}

TEST(ResolveTolerances, EmptyBoxGivesNone) {
  EXPECT_EQ(resolve_tolerances({}, Box3()).degeneracy, 0.0);
  EXPECT_EQ(resolve_tolerances({}, Box3(Vec3(1, 2, 3))).degeneracy, 0.0);
}

TEST(ResolveTolerances, LargestBoxGivesAFiniteLength) {
  const Box3 box(Vec3::Constant(-1.7e308), Vec3::Constant(1.7e308));
  EXPECT_NEAR(resolve_tolerances({}, box).degeneracy / (std::sqrt(3.0) * 1.7e300), 2.0, 1e-12);
}

TEST(ResolveTolerances, RefusesWhatIsNoLength) {
  const Box3 box = box_of_diagonal_thirteen();
  EXPECT_THROW((void)resolve_tolerances({.tolerance = -1.0}, box), InvalidArgument);
  EXPECT_THROW((void)resolve_tolerances({.degeneracy = kInfinity}, box), InvalidArgument);
  EXPECT_THROW((void)resolve_tolerances({.slit = std::nan("")}, box), InvalidArgument);
  EXPECT_THROW((void)resolve_tolerances({.height = -1e-300}, box), InvalidArgument);
}

TEST(ResolveTolerances, RefusesAngleThatNoFoldHas) {
  const Box3 box = box_of_diagonal_thirteen();
  for (const double angle : {-0.1, 180.1, kInfinity, std::nan("")}) {
    EXPECT_THROW((void)resolve_tolerances({.max_foldover_angle = angle}, box), InvalidArgument);
  }
  EXPECT_EQ(resolve_tolerances({.max_foldover_angle = 180.0}, box).max_foldover_angle, 180.0);
}

TEST(Inconsistencies, ToleranceBelowDegeneracyIsNamed) {
  const auto said = inconsistencies({.degeneracy = 0.5, .slit = 0.25, .height = 0.125});
  ASSERT_EQ(said.size(), 2U);
  EXPECT_EQ(said[0], "the slit tolerance (0.25) is below the degeneracy tolerance (0.5)");
  EXPECT_EQ(said[1], "the height tolerance (0.125) is below the degeneracy tolerance (0.5)");
}

TEST(Inconsistencies, EqualOrLargerTolerancesAreConsistent) {
  EXPECT_TRUE(inconsistencies({.degeneracy = 0.5, .slit = 0.5, .height = 0.5}).empty());
  EXPECT_TRUE(inconsistencies({.degeneracy = 0.5, .slit = 0.6, .height = 7.0}).empty());
}

}  // namespace
}  // namespace meshalyzer
