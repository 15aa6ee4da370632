#include "meshalyzer/geometry/face_shape.h"

#include "meshalyzer/mesh/build.h"
#include "support/constants.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace meshalyzer {
namespace {

/// Returns the shape of a single face.
FaceShape shape_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  return measure_face_shapes(build(shapes::make({a, b, c}, {{0, 1, 2}})).mesh).at(0);
}

TEST(FaceShape, RightTriangleHasItsFigures) {
  const FaceShape shape = shape_of({0, 0, 0}, {3, 0, 0}, {0, 4, 0});
  EXPECT_EQ(shape.normal, Vec3::UnitZ());
  EXPECT_EQ(shape.true_area(), 6.0);
  EXPECT_NEAR(shape.angle[0], kPi / 2, 1e-15);
  EXPECT_NEAR(shape.angle[1], std::atan2(4, 3), 1e-15);
  EXPECT_NEAR(shape.angle[2], std::atan2(3, 4), 1e-15);
}

TEST(FaceShape, AnglesOfALineAreZeroButBetweenItsEnds) {
  const FaceShape shape = shape_of({0, 0, 0}, {1, 1, 1}, {3, 3, 3});
  EXPECT_EQ(shape.area, 0.0);
  EXPECT_EQ(shape.normal, Vec3::Zero());
  EXPECT_EQ(shape.angle, (std::array{0.0, kPi, 0.0}));
}

TEST(FaceShape, CornersAtOnePlaceShareTheAngles) {
  const Vec3 here(1, 2, 3);
  const Vec3 there(4, 5, 7);
  EXPECT_EQ(shape_of(here, here, there).angle, (std::array{kPi / 2, kPi / 2, 0.0}));
  EXPECT_EQ(shape_of(there, here, here).angle, (std::array{0.0, kPi / 2, kPi / 2}));
  EXPECT_EQ(shape_of(here, there, here).angle, (std::array{kPi / 2, 0.0, kPi / 2}));
  EXPECT_EQ(shape_of(here, here, here).angle, (std::array{kPi / 3, kPi / 3, kPi / 3}));
}

TEST(FaceShape, AnglesAndNormalAreThoseOfAnySize) {
  for (const double size : {0x1p-1060, 0x1p-300, 0x1p300, 0x1p1020}) {
    const FaceShape shape = shape_of({0, 0, 0}, {3 * size, 0, 0}, {0, 4 * size, 0});
    EXPECT_EQ(shape.normal, Vec3::UnitZ());
    EXPECT_NEAR(shape.angle[1], std::atan2(4, 3), 1e-15);
    EXPECT_EQ(std::ldexp(shape.area, 2 * (shape.exponent - std::ilogb(size))), 6.0);
  }
}

TEST(FaceShape, SidesLongerThanAnyDoubleHaveAnglesToo) {
  // From -1e308 to 1e308 it is 2e308, which overflows.
  const FaceShape shape = shape_of({-1e308, 0, 0}, {1e308, 0, 0}, {-1e308, 2e307, 0});
  EXPECT_EQ(shape.normal, Vec3::UnitZ());
  EXPECT_NEAR(shape.angle[0], kPi / 2, 1e-15);
  EXPECT_NEAR(shape.angle[1], std::atan2(1, 10), 1e-15);
}

}  // namespace
}  // namespace meshalyzer
