#include "meshalyzer/exact/normal.h"

#include "random_points.h"
#include "support/rational_oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace meshalyzer {
namespace {

constexpr std::uint32_t kSeed = 20261121;
constexpr int kRounds = 1000;
constexpr double kError = 1e-9;

/// Expects that the normal is right, where doubles can hold it, and zero exactly for collinear
/// points.
void expect_accurate(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = accurate_normal(a, b, c);
  if (test::is_rational_normal_within({a, b, c}, 1e-290, 1e300)) {
    EXPECT_TRUE(test::is_rational_normal(normal, {a, b, c}, kError)) << normal.transpose();
  }
  if (are_collinear(a, b, c)) {
    EXPECT_EQ(normal, Vec3::Zero());
  }
}

TEST(AccurateNormal, HasTheDirectionOfTheRightHandAndTwiceTheArea) {
  EXPECT_EQ(accurate_normal({0, 0, 0}, {2, 0, 0}, {0, 3, 0}), Vec3(0, 0, 6));
  EXPECT_EQ(accurate_normal({0, 0, 0}, {0, 3, 0}, {2, 0, 0}), Vec3(0, 0, -6));
}

TEST(AccurateNormal, AgreesWithRationalsOnPointsOfAllMagnitudes) {
  for (const Cloud cloud : kClouds) {
    RandomPoints points(kSeed);
    for (int round = 0; round < kRounds && !HasFailure(); ++round) {
      SCOPED_TRACE(testing::Message() << "cloud " << static_cast<int>(cloud) << " round " << round);
      const Vec3 a = points.next(cloud);
      const Vec3 b = points.next(cloud);
      expect_accurate(a, b, points.next(cloud));
    }
  }
}

TEST(AccurateNormal, SliverOfAnyHeightKeepsItsDigits) {
  // The third corner is a rounded point of the line through the others, moved by 2^-k.
  RandomPoints points(kSeed);
  std::mt19937 random(kSeed);
  for (int round = 0; round < 5 * kRounds && !HasFailure(); ++round) {
    SCOPED_TRACE(round);
    const Vec3 a = points.next(Cloud::Generic);
    const Vec3 b = points.next(Cloud::Generic);
    const double t = std::ldexp(static_cast<double>(random() % 1024), -9);
    const double height = std::ldexp(1.0, -static_cast<int>(random() % 70));
    const Vec3 c = a + t * (b - a) + height * points.next(Cloud::Generic);
    expect_accurate(a, b, c);
    expect_accurate(b, c, a);
    const Vec3 far = Vec3(1e8, -3e7, 1e5);
    expect_accurate(a + far, b + far, c + far);
  }
}

TEST(AccurateNormal, SliverOneBitHighHasItsTrueArea) {
  // On the line x = y = z but for u = one bit of a coordinate, with s = 0.7 - 0.1 as the doubles
  // are: (s, s, s) x (t, t, t + u) = (s u, -s u, 0).
  const double next = std::nextafter(0.3, 1.0);
  const double su = (0.7 - 0.1) * (next - 0.3);
  const Vec3 normal = accurate_normal(Vec3::Constant(0.1), Vec3::Constant(0.7), {0.3, 0.3, next});
  EXPECT_NEAR(normal.x() / su, 1.0, kError);
  EXPECT_NEAR(normal.y() / su, -1.0, kError);
  EXPECT_EQ(normal.z(), 0.0);
}

TEST(AccurateNormal, CollinearPointsHaveNone) {
  EXPECT_EQ(accurate_normal(Vec3::Constant(0.1), Vec3::Constant(0.3), Vec3::Constant(0.7)),
            Vec3::Zero());
  EXPECT_EQ(accurate_normal({1, 2, 3}, {1, 2, 3}, {4, 5, 6}), Vec3::Zero());
}

TEST(AccurateNormal, OverflowsToInfinityOnlyWhereTheTruthDoes) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(accurate_normal({0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}), Vec3(0, 0, infinity));
  // 1e200 * 1e-200: the product of the largest entries overflows, the normal does not.
  const Vec3 normal = accurate_normal({0, 0, 0}, {1e200, 0, 0}, {1e200, 1e-200, 0});
  EXPECT_NEAR(normal.z(), 1.0, kError);
}

TEST(AccurateNormal, UnderflowsToZeroOnlyWhereTheTruthDoes) {
  EXPECT_EQ(accurate_normal({0, 0, 0}, {1e-200, 0, 0}, {0, 1e-200, 0}), Vec3::Zero());
  const Vec3 normal = accurate_normal({0, 0, 0}, {1e-150, 0, 0}, {0, 1e-150, 0});
  EXPECT_NEAR(normal.z() / 1e-300, 1.0, kError);
}

TEST(UnitNormal, TrianglesOfAnySizeHaveOne) {
  for (const double size : {1e-300, 1e-200, 1e-140, 1.0, 1e140, 1e200, 1e300}) {
    SCOPED_TRACE(size);
    const Corners t{Vec3(0, 0, 0), Vec3(size, 0, 0), Vec3(0, size, size)};
    const Vec3 diagonal = Vec3(0, -1, 1).normalized();
    EXPECT_LT((unit_normal(t) - diagonal).norm(), kError);
    EXPECT_EQ(unit_normal({t[0], t[1], Vec3(size / 2, 0, 0)}), Vec3::Zero());
  }
}

TEST(UnitNormal, TinyTrianglesFarFromTheOriginHaveOne) {
  const Corners t{Vec3(1e100, 0, 0), Vec3(1e100, 1e-200, 0), Vec3(1e100, 0, 1e-200)};
  EXPECT_EQ(unit_normal(t), Vec3(1, 0, 0));
  EXPECT_EQ(unit_normal({t[0], t[0], t[0]}), Vec3::Zero());
}

TEST(UnitNormal, LargestTrianglesHaveOne) {
  const double most = std::numeric_limits<double>::max();
  EXPECT_EQ(unit_normal({Vec3(-most, -most, 0), Vec3(most, -most, 0), Vec3(-most, most, 0)}),
            Vec3(0, 0, 1));
}

TEST(RescaledNormal, PowersOfTwoChangeNoDigit) {
  const Corners t{Vec3(0.1, 0.7, 0.3), Vec3(0.9, 0.2, 0.4), Vec3(0.6, 0.5, 0.8)};
  for (const int exponent : {-1000, -500, 500, 1000}) {
    Corners scaled = t;
    for (Vec3& corner : scaled) corner *= std::ldexp(1.0, exponent);
    EXPECT_EQ(rescaled_normal(scaled), rescaled_normal(t));
  }
}

}  // namespace
}  // namespace meshalyzer
