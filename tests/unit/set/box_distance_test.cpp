#include "meshalyzer/set/box_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace meshalyzer {
namespace {

constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();

Box3 unit_box(const Vec3& low) {
  return {low, low + Vec3::Ones()};
}

TEST(BoxDistance, IsThatOfTheirNearestCornersEdgesOrSides) {
  const Box3 box = unit_box({0, 0, 0});
  // 3^2 + 4^2 = 5^2, and with 12^2 13^2.
  EXPECT_EQ(distance(box, unit_box({4, 0.5, -0.5})), 3.0);
  EXPECT_EQ(distance(box, unit_box({4, -5, 0})), 5.0);
  EXPECT_EQ(distance(box, unit_box({4, -5, 13})), 13.0);
  EXPECT_EQ(distance(unit_box({4, -5, 13}), box), 13.0);
  EXPECT_EQ(distance(box, Box3(Vec3(0.5, 3, 0.5))), 2.0);
}

TEST(BoxDistance, IsNothingWhereTheyTouchOverlapOrContain) {
  const Box3 box = unit_box({0, 0, 0});
  for (const Box3& other :
       {unit_box({1, 1, 1}), unit_box({0.5, -0.5, 0}), box, Box3(Vec3::Constant(0.5)),
        Box3(Vec3::Constant(-9), Vec3::Constant(9))}) {
    EXPECT_EQ(distance(box, other), 0.0);
    EXPECT_EQ(distance(other, box), 0.0);
  }
}

TEST(BoxDistance, SquaresNeitherOverflowNorUnderflow) {
  const Box3 origin(Vec3::Zero());
  EXPECT_NEAR(distance(origin, Box3(Vec3::Constant(1e200))) / 1e200, std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(distance(origin, Box3(Vec3::Constant(1e-200))) / 1e-200, std::sqrt(3.0), 1e-15);
  EXPECT_EQ(distance(origin, Box3(Vec3(0, kTiny, 0))), kTiny);
  // The true distance is larger than any double.
  EXPECT_EQ(distance(Box3(Vec3(-kMax, 0, 0)), Box3(Vec3(kMax, 0, 0))),
            std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace meshalyzer
