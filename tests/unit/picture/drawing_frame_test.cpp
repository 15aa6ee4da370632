#include "meshalyzer/picture/internal/drawing_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace meshalyzer {
namespace {

TEST(DrawingFrame, UsualSizesAreMovedButNotScaled) {
  const DrawingFrame frame(Box3(Vec3(1, 2, 3), Vec3(3, 6, 7)));
  EXPECT_EQ(frame.centre(), Vec3(2, 4, 5));
  EXPECT_EQ(frame.scale(), 1.0);
  // Half of the diagonal (2, 4, 4).
  EXPECT_DOUBLE_EQ(frame.radius(), 3.0);
  EXPECT_EQ(frame(Vec3(3, 2, 7)), Vec3(1, -2, 2));
}

TEST(DrawingFrame, TinyAndHugeSizesAreScaledByAPowerOfTwoToAboutOne) {
  for (const double size : {1e-320, 1e-310, 1e-30, 1e-3, 1e7, 1e40, 1e308}) {
    const DrawingFrame frame(Box3(Vec3(0, 0, 0), Vec3(size, size / 2, 0)));
    EXPECT_EQ(std::exp2(std::ilogb(frame.scale())), frame.scale()) << size;
    EXPECT_GT(frame.radius(), 0.0) << size;
    // A length that the scale, itself a double, can bring no nearer to 1.
    if (size > 1e-306) {
      EXPECT_GE(frame.radius(), 1.0) << size;
      EXPECT_LT(frame.radius(), 4.0) << size;
    }
    const Vec3 drawn = frame(Vec3(size, size / 2, 0));
    EXPECT_TRUE(drawn.allFinite());
    EXPECT_NEAR(drawn.norm(), frame.radius(), 1e-3 * frame.radius());
  }
}

TEST(DrawingFrame, BoxWithoutSizeHasARadius) {
  EXPECT_EQ(DrawingFrame(Box3()).radius(), 1.0);
  const DrawingFrame point(Box3(Vec3(7, 7, 7), Vec3(7, 7, 7)));
  EXPECT_EQ(point.radius(), 1.0);
  EXPECT_EQ(point(Vec3(7, 7, 7)), Vec3(0, 0, 0));
}

TEST(DrawingFrame, WhatIsFarAwayStaysFinite) {
  const DrawingFrame frame(Box3(Vec3(0, 0, 0), Vec3(1, 1, 1)));
  constexpr double kMax = std::numeric_limits<double>::max();
  const Vec3 drawn = frame(Vec3(kMax, -kMax, 0.5));
  EXPECT_TRUE(std::isfinite(static_cast<float>(drawn.squaredNorm())));
  EXPECT_GT(drawn.x(), 1e6);
  EXPECT_LT(drawn.y(), -1e6);
  EXPECT_EQ(drawn.z(), 0.0);
}

}  // namespace
}  // namespace meshalyzer
