#include "meshalyzer/spatial/direction_off.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace meshalyzer {
namespace {

double clearance_of(const Vec3& direction, const std::vector<Vec3>& normals) {
  double least = 1.0;
  for (const Vec3& normal : normals) least = std::min(least, normal.dot(direction));
  return least;
}

TEST(DirectionOff, OneFaceIsLeftAlongItsNormal) {
  const DirectionOff off = direction_off({{0, 0.6, 0.8}});
  EXPECT_LT((off.direction - Vec3(0, 0.6, 0.8)).norm(), 1e-15);
  EXPECT_NEAR(off.clearance, 1.0, 1e-15);
}

TEST(DirectionOff, CornerOfACubeIsLeftAlongTheDiagonal) {
  const DirectionOff off = direction_off({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}});
  EXPECT_LT((off.direction - Vec3(1, 1, 1) / std::sqrt(3.0)).norm(), 1e-14);
  EXPECT_NEAR(off.clearance, 1.0 / std::sqrt(3.0), 1e-14);
}

TEST(DirectionOff, NarrowWedgeIsLeftThroughItsOpening) {
  // Two walls with an angle of 2e-6 between them.
  const double half = 1e-6;
  const std::vector<Vec3> walls{{std::cos(half), std::sin(half), 0},
                                {-std::cos(half), std::sin(half), 0}};
  const DirectionOff off = direction_off(walls);
  EXPECT_NEAR(off.direction.y(), 1.0, 1e-9);
  EXPECT_NEAR(off.clearance, half, 1e-12);
}

TEST(DirectionOff, NoDirectionLeavesFacesAllAround) {
  EXPECT_LE(direction_off({{1, 0, 0}, {-1, 0, 0}}).clearance, 1e-15);
  EXPECT_LE(direction_off({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}})
                .clearance,
            1e-15);
  const double third = 1.0 / std::sqrt(3.0);
  EXPECT_LE(direction_off({third * Vec3(1, 1, 1), third * Vec3(1, -1, -1), third * Vec3(-1, 1, -1),
                           third * Vec3(-1, -1, 1)})
                .clearance,
            0.0);
}

TEST(DirectionOff, IsTheBestOfManyDirections) {
  std::mt19937 random(7);
  std::normal_distribution<double> coordinate;
  const auto unit = [&] {
    return Vec3(coordinate(random), coordinate(random), coordinate(random)).normalized();
  };
  int n_leaving = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<Vec3> normals;
    for (int k = 0; k < 1 + i % 9; ++k) normals.push_back((unit() + Vec3(0, 0, 0.8)).normalized());
    const DirectionOff off = direction_off(normals);
    double best = 0.0;
    for (int k = 0; k < 2000; ++k) best = std::max(best, clearance_of(unit(), normals));
    EXPECT_TRUE(best == 0.0 || off.clearance >= best - 1e-12) << i;
    if (off.clearance <= 0.0) continue;
    ++n_leaving;
    EXPECT_NEAR(off.direction.norm(), 1.0, 1e-14);
    EXPECT_NEAR(off.clearance, clearance_of(off.direction, normals), 1e-15);
  }
  EXPECT_GT(n_leaving, 100);
}

}  // namespace
}  // namespace meshalyzer
