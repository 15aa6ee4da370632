#include "meshalyzer/exact/predicates.h"

#include "random_points.h"
#include "support/rational_oracle.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace meshalyzer {
namespace {

constexpr std::uint32_t kSeed = 20261121;
constexpr int kRounds = 1000;
constexpr std::array<Axis, 3> kAxes{Axis::X, Axis::Y, Axis::Z};

/// Calls `body` with four random points, many times for each cloud, until it fails.
template <typename Body>
void for_random_points(const Body& body) {
  for (const Cloud cloud : kClouds) {
    RandomPoints points(kSeed);
    for (int round = 0; round < kRounds && !testing::Test::HasFailure(); ++round) {
      SCOPED_TRACE(testing::Message() << "cloud " << static_cast<int>(cloud) << " round " << round);
      const Vec3 a = points.next(cloud);
      const Vec3 b = points.next(cloud);
      const Vec3 c = points.next(cloud);
      body(a, b, c, points.next(cloud));
    }
  }
}

TEST(Orient3d, PointOnTheSideOfTheNormalIsPositive) {
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), -1);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, -8, 0}), 0);
}

TEST(Orient3d, SmallestDoubleOffThePlaneIsSeen) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(orient3d({-1, -1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, tiny}), 1);
  EXPECT_EQ(orient3d({-1, -1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -tiny}), -1);
}

TEST(Orient3d, CollinearPointsAreInAPlaneWithAnyOther) {
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {0.1, -0.7, 5}), 0);
}

TEST(Orient3d, AgreesWithRationalsOnPointsOfAllMagnitudes) {
  for_random_points([](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    EXPECT_EQ(orient3d(a, b, c, d), test::rational_orient3d(a, b, c, d));
  });
}

TEST(Orient3d, ExchangingTwoArgumentsNegates) {
  for_random_points([](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Sign sign = orient3d(a, b, c, d);
    EXPECT_EQ(orient3d(b, a, c, d), -sign);
    EXPECT_EQ(orient3d(a, c, b, d), -sign);
    EXPECT_EQ(orient3d(a, b, d, c), -sign);
    EXPECT_EQ(orient3d(d, b, c, a), -sign);
  });
}

TEST(Orient3d, CyclicShiftOfThreeKeepsAndOfFourNegates) {
  for_random_points([](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Sign sign = orient3d(a, b, c, d);
    EXPECT_EQ(orient3d(b, c, a, d), sign);
    EXPECT_EQ(orient3d(b, c, d, a), -sign);
  });
}

TEST(Orient3d, PointReflectionNegates) {
  for_random_points([](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    EXPECT_EQ(orient3d(-a, -b, -c, -d), -orient3d(a, b, c, d));
  });
}

TEST(Orient3dIfSure, NeverContradictsTheExactSign) {
  for_random_points([](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    EXPECT_EQ(orient3d_if_sure(a, b, c, d).value_or(test::rational_orient3d(a, b, c, d)),
              test::rational_orient3d(a, b, c, d));
  });
}

TEST(Orient3dIfSure, GenericPointsAreNearlyAlwaysSure) {
  RandomPoints points(kSeed);
  int unsure = 0;
  for (int round = 0; round < 10 * kRounds; ++round) {
    const Vec3 a = points.next(Cloud::Generic);
    const Vec3 b = points.next(Cloud::Generic);
    const Vec3 c = points.next(Cloud::Generic);
    unsure += orient3d_if_sure(a, b, c, points.next(Cloud::Generic)) ? 0 : 1;
  }
  // The bound is about 1e-14 of the box of the points; so near a plane no random point comes.
  EXPECT_EQ(unsure, 0);
}

TEST(Orient3dIfSure, AxisParallelPlaneIsSurelyFlat) {
  EXPECT_EQ(orient3d_if_sure({0.1, 0.2, 0.3}, {0.7, -0.1, 0.3}, {5, 0.9, 0.3}, {-3, 4, 0.3}), 0);
}

TEST(Orient2d, FramesFollowTheCyclicOrderOfTheAxes) {
  const Vec3 o(0, 0, 0);
  const Vec3 x(1, 0, 0);
  const Vec3 y(0, 1, 0);
  const Vec3 z(0, 0, 1);
  EXPECT_EQ(orient2d(Axis::X, o, y, z), 1);
  EXPECT_EQ(orient2d(Axis::Y, o, z, x), 1);
  EXPECT_EQ(orient2d(Axis::Z, o, x, y), 1);
  EXPECT_EQ(orient2d(Axis::Z, o, x, x + z), 0);
}

TEST(Orient2d, AgreesWithRationalsOnPointsOfAllMagnitudes) {
  for_random_points([](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3&) {
    for (const Axis axis : kAxes) {
      EXPECT_EQ(orient2d(axis, a, b, c), test::rational_orient2d(axis, a, b, c));
    }
  });
}

TEST(Orient2d, ExchangeNegatesAndCyclicShiftKeeps) {
  for_random_points([](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3&) {
    for (const Axis axis : kAxes) {
      const Sign sign = orient2d(axis, a, b, c);
      EXPECT_EQ(orient2d(axis, b, a, c), -sign);
      EXPECT_EQ(orient2d(axis, a, c, b), -sign);
      EXPECT_EQ(orient2d(axis, b, c, a), sign);
    }
  });
}

TEST(Orient2dIfSure, NeverContradictsTheExactSign) {
  for_random_points([](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3&) {
    for (const Axis axis : kAxes) {
      const Sign truth = test::rational_orient2d(axis, a, b, c);
      EXPECT_EQ(orient2d_if_sure(axis, a, b, c).value_or(truth), truth);
    }
  });
}

TEST(Orient2dIfSure, GenericPointsAreNearlyAlwaysSure) {
  RandomPoints points(kSeed);
  int unsure = 0;
  for (int round = 0; round < 10 * kRounds; ++round) {
    const Vec3 a = points.next(Cloud::Generic);
    const Vec3 b = points.next(Cloud::Generic);
    unsure += orient2d_if_sure(Axis::Z, a, b, points.next(Cloud::Generic)) ? 0 : 1;
  }
  EXPECT_EQ(unsure, 0);
}

TEST(AreCollinear, AgreesWithRationalsOnPointsOfAllMagnitudes) {
  for_random_points([](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3&) {
    bool truth = true;
    for (const Axis axis : kAxes) truth = truth && test::rational_orient2d(axis, a, b, c) == 0;
    EXPECT_EQ(are_collinear(a, b, c), truth);
  });
}

TEST(AreCollinear, RepeatedPointIsInLineWithAnyOther) {
  for_random_points([](const Vec3& a, const Vec3& b, const Vec3&, const Vec3&) {
    EXPECT_TRUE(are_collinear(a, a, b));
    EXPECT_TRUE(are_collinear(a, b, a));
    EXPECT_TRUE(are_collinear(b, a, a));
  });
}

TEST(AreCollinear, OneBitOffTheLineIsNotCollinear) {
  // The line x = y = z holds these three but for the last bit of one coordinate.
  EXPECT_TRUE(are_collinear(Vec3::Constant(0.1), Vec3::Constant(0.3), Vec3::Constant(0.7)));
  EXPECT_FALSE(are_collinear(Vec3::Constant(0.1), {0.3, 0.3, std::nextafter(0.3, 1.0)},
                             Vec3::Constant(0.7)));
}

TEST(ProjectionAxis, ShowsAreaExactlyWhereThereIsSome) {
  for_random_points([](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3&) {
    const std::optional<Axis> axis = projection_axis(a, b, c);
    EXPECT_EQ(axis.has_value(), !are_collinear(a, b, c));
    if (axis) {
      EXPECT_NE(test::rational_orient2d(*axis, a, b, c), 0);
    }
  });
}

TEST(ProjectionAxis, LargestComponentOfTheNormalIsDropped) {
  // The normals are multiples of (5, -1, 1), (1, -5, 1), (1, 1, 5): u x v of u and v orthogonal to
  // each.
  EXPECT_EQ(projection_axis({0, 0, 0}, {0, 1, 1}, {1, 5, 0}), Axis::X);
  EXPECT_EQ(projection_axis({0, 0, 0}, {1, 0, -1}, {5, 1, 0}), Axis::Y);
  EXPECT_EQ(projection_axis({0, 0, 0}, {1, -1, 0}, {5, 0, -1}), Axis::Z);
}

}  // namespace
}  // namespace meshalyzer
