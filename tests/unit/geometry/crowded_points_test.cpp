#include "meshalyzer/geometry/crowded_points.h"

#include "meshalyzer/geometry/coincidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

bool has(const std::vector<Index>& ascending, std::size_t i) {
  return std::binary_search(ascending.begin(), ascending.end(), static_cast<Index>(i));
}

/// Points of a box of this size about a centre, each followed by one that differs from it by a
/// share of the tolerance on every axis.
std::vector<Vec3> twins(const Vec3& centre, double size, double share) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-size, size);
  std::vector<Vec3> points;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p = centre + Vec3(uniform(random), uniform(random), uniform(random));
    points.push_back(p);
    points.push_back(p + share * 1e-10 * p.cwiseAbs().cwiseMax(1.0));
  }
  return points;
}

TEST(FindCrowdedPoints, NoPointThatHasAnotherOneAtItsPlaceIsMissing) {
  for (const double size : {1e-9, 1e-3, 1.0, 1e6}) {
    for (const double offset : {0.0, 1.0, -1e4}) {
      for (const double share : {0.0, 0.5, 0.999999}) {
        const std::vector<Vec3> points = twins(Vec3(offset, 0, -offset), size, share);
        const std::vector<Index> crowded = find_crowded_points(points);
        for (std::size_t i = 0; i < points.size(); i += 2) {
          if (!is_indistinguishable(points[i], points[i + 1], Coincidence::Tolerant)) continue;
          ASSERT_TRUE(has(crowded, i) && has(crowded, i + 1)) << size << ' ' << offset << ' ' << i;
        }
      }
    }
  }
}

TEST(FindCrowdedPoints, FewPointsOfAGridAreReturned) {
  // The chance that two cells share a slot is 1 / 16.
  std::vector<Vec3> points;
  for (int x = 0; x < 128; ++x) {
    for (int y = 0; y < 128; ++y) points.emplace_back(x, y, 0);
  }
  EXPECT_LT(find_crowded_points(points).size(), points.size() / 8);
}

TEST(FindCrowdedPoints, AllPointsAreReturnedWhereCellsWouldBeAsNarrowAsTheTolerance) {
  EXPECT_EQ(find_crowded_points(twins(Vec3::Zero(), 1e-7, 0.0)).size(), 10000U);
  EXPECT_EQ(find_crowded_points(std::vector<Vec3>(3, Vec3(1, 2, 3))).size(), 3U);
}

TEST(FindCrowdedPoints, TheWidestBoxDoesNotOverflow) {
  const std::vector<Vec3> points{Vec3::Constant(1.7e308), Vec3::Constant(-1.7e308),
                                 Vec3::Constant(1.7e308)};
  const std::vector<Index> crowded = find_crowded_points(points);
  EXPECT_TRUE(has(crowded, 0) && has(crowded, 2));
}

}  // namespace
}  // namespace meshalyzer
