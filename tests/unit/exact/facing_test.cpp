#include "meshalyzer/exact/facing.h"

#include "random_points.h"
#include "support/rational_oracle.h"

#include <gtest/gtest.h>

#include <array>

namespace meshalyzer {
namespace {

constexpr std::uint32_t kSeed = 20270114;
constexpr int kRounds = 300;

/// det(b - a, c - a, d) = det(b, c, d) + det(c, a, d) + det(a, b, d).
Sign rational_facing(const Vec3& d, const Vec3& a, const Vec3& b, const Vec3& c) {
  return test::rational_volume_sign(std::array<Vec3, 9>{b, c, d, c, a, d, a, b, d});
}

TEST(Facing, IsPositiveOnTheSideOfTheNormal) {
  const Vec3 a(0, 0, 5);
  const Vec3 b(1, 0, 5);
  const Vec3 c(0, 1, 5);
  EXPECT_EQ(facing({0.3, -0.4, 1e-12}, a, b, c), 1);
  EXPECT_EQ(facing({0.3, -0.4, -1e-12}, a, b, c), -1);
  EXPECT_EQ(facing({0.3, -0.4, 0}, a, b, c), 0);
  EXPECT_EQ(facing({0, 0, 1}, a, c, b), -1);
}

TEST(Facing, IsNothingForATriangleWithoutAreaAndForNoDirection) {
  EXPECT_EQ(facing({1, 2, 3}, {0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.4, 0.4, 0.4}), 0);
  EXPECT_EQ(facing(Vec3::Zero(), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0);
}

TEST(Facing, AgreesWithRationalsOnPointsOfAllMagnitudes) {
  for (const Cloud cloud : kClouds) {
    RandomPoints points(kSeed);
    for (int round = 0; round < kRounds && !HasFailure(); ++round) {
      SCOPED_TRACE(testing::Message() << "cloud " << static_cast<int>(cloud) << " round " << round);
      const Vec3 a = points.next(cloud);
      const Vec3 b = points.next(cloud);
      const Vec3 c = points.next(cloud);
      const Vec3 direction = points.next(cloud);
      EXPECT_EQ(facing(direction, a, b, c), rational_facing(direction, a, b, c));
      // A direction along the triangle but for rounding, in which the filter cannot be sure.
      const Vec3 along = 0.3 * (b / 2 - a / 2) + 0.7 * (c / 2 - a / 2);
      EXPECT_EQ(facing(along, a, b, c), rational_facing(along, a, b, c));
    }
  }
}

}  // namespace
}  // namespace meshalyzer
