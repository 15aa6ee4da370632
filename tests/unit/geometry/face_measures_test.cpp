#include "meshalyzer/geometry/face_measures.h"

#include "meshalyzer/mesh/build.h"
#include "support/constants.h"
#include "support/shape_figures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

namespace meshalyzer {
namespace {

FaceMeasures measure(const Soup& soup) {
  return measure_faces(build(soup).mesh);
}

/// Area and aspect ratio of one triangle, which must not depend on the corner that comes first.
void expect_triangle(const std::vector<Vec3>& corners, double area, double aspect_ratio) {
  for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{1, 2, 0}, Triangle{2, 0, 1}}) {
    const FaceMeasures faces = measure(shapes::make(corners, {t}));
    ASSERT_EQ(faces.area.size(), 1U);
    EXPECT_NEAR(faces.area[0] / area, 1.0, 1e-9);
    EXPECT_NEAR(faces.aspect_ratio[0] / aspect_ratio, 1.0, 1e-9);
    EXPECT_TRUE(faces.zero_area.empty());
  }
}

/// The smallest corner angle of one triangle, whichever corner comes first.
void expect_corner_angle(const std::vector<Vec3>& corners, double degrees) {
  for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{1, 2, 0}, Triangle{2, 0, 1}}) {
    const FaceMeasures faces = measure(shapes::make(corners, {t}));
    ASSERT_EQ(faces.corner_angle.size(), 1U);
    EXPECT_NEAR(faces.corner_angle[0] / degrees, 1.0, 1e-12);
  }
}

TEST(FaceCorners, RunCounterClockwiseFromAnyOfThem) {
  const CutMesh cut = build(shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, {{2, 0, 1}}));
  const std::array<Vec3, 3> p = face_corners(cut.mesh, FaceHandle(0));
  EXPECT_EQ((p[1] - p[0]).cross(p[2] - p[0]), Vec3(0, 0, 2));
}

TEST(MeasureFaces, NoFacesHaveNoMeasures) {
  const FaceMeasures faces = measure(Soup{});
  EXPECT_TRUE(faces.area.empty());
  EXPECT_TRUE(faces.aspect_ratio.empty());
  EXPECT_TRUE(faces.corner_angle.empty());
  EXPECT_TRUE(faces.zero_area.empty());
}

TEST(MeasureFaces, EquilateralTriangleHasTheSmallestAspectRatio) {
  // Sides sqrt 2, altitudes sqrt(3/2), area (sqrt 3)/2.
  using std::numbers::sqrt3;
  expect_triangle({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, sqrt3 / 2, 2 / sqrt3);
}

TEST(MeasureFaces, HalfASquareHasARatioOfTwoExactly) {
  // So that no threshold of 2 is exceeded.
  for (const double side : {1.0, 3.0, 0.1, 1e200, 1e-200}) {
    const Soup half = shapes::make({{0, 0, 0}, {side, 0, 0}, {0, side, 0}}, {{0, 1, 2}});
    EXPECT_EQ(measure(half).aspect_ratio, std::vector<double>{2.0});
  }
}

TEST(MeasureFaces, SmallestCornerAngleOfAnEquilateralTriangleIs60) {
  expect_corner_angle({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 60);
}

TEST(MeasureFaces, SmallestCornerAngleOfARightTriangleIsOppositeToItsShortLeg) {
  // Legs 1 and e: atan(e), beside 90 and 90 - atan(e).
  for (const double e : {1.0, 0.5, 1e-3, 1e-12, 1e-100}) {
    expect_corner_angle({{0, 0, 0}, {1, 0, 0}, {0, e, 0}}, std::atan(e) * 180 / std::numbers::pi);
  }
}

TEST(MeasureFaces, SmallestCornerAngleOfACapIsThatAtItsBase) {
  // Base 2, apex over its middle: atan(height) twice, where floating point would lose the height.
  for (const double height : {0.5, 1e-9, 1e-30}) {
    expect_corner_angle({{0, 0, 0}, {2, 0, 0}, {1, height, 0}},
                        std::atan(height) * 180 / std::numbers::pi);
  }
}

TEST(MeasureFaces, SmallestCornerAngleIsTheSameAtAnyScale) {
  // Products of the lengths overflow, or vanish.
  for (const double scale : {1e300, 1e160, 1e-160, 1e-300}) {
    expect_corner_angle({{0, 0, 0}, {scale, 0, 0}, {0, scale, 0}}, 45);
  }
}

TEST(MeasureFaces, SmallestCornerAngleOfAFaceOfZeroAreaIsZero) {
  EXPECT_EQ(measure(shapes::make({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, {{0, 1, 2}})).corner_angle,
            std::vector<double>{0.0});
}

TEST(MeasureFaces, NeedleIsMeasuredByItsLongestSide) {
  // Legs 1 and e: the altitude on the hypotenuse h is e / h, so the ratio is h^2 / e.
  for (const double e : {0.5, 1e-3, 1e-12}) {
    expect_triangle({{0, 0, 0}, {1, 0, 0}, {0, e, 0}}, e / 2, (1 + e * e) / e);
  }
}

TEST(MeasureFaces, CapIsMeasuredByItsHeight) {
  // Base 1, apex over its middle: the ratio is 1 / height.
  for (const double height : {0.5, 1e-3, 1e-20, 1e-150}) {
    expect_triangle({{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}}, height / 2, 1 / height);
  }
}

TEST(MeasureFaces, SliverAcrossTheAxesKeepsItsDigits) {
  // Two corners on the line x = y = z, the third off it by u = one bit of z: the base is s sqrt 3
  // long with s = 0.7 - 0.1, the height u sqrt(2/3).
  const double next = std::nextafter(0.3, 1.0);
  const double s = 0.7 - 0.1;
  const double height = (next - 0.3) * std::sqrt(2.0 / 3.0);
  const double base = s * std::numbers::sqrt3;
  expect_triangle({Vec3::Constant(0.1), Vec3::Constant(0.7), {0.3, 0.3, next}}, base * height / 2,
                  base / height);
}

TEST(MeasureFaces, AnySizeIsMeasuredWithoutOverflow) {
  // The smallest and the largest: the area overflows, the ratio does not.
  expect_triangle({{0, 0, 0}, {4e-150, 0, 0}, {0, 3e-150, 0}}, 6e-300, 25.0 / 12);
  const FaceMeasures huge =
      measure(shapes::make({{0, 0, 0}, {1e160, 0, 0}, {0, 1e140, 0}}, {{0, 1, 2}}));
  EXPECT_NEAR(huge.area[0] / 5e299, 1.0, 1e-9);
  EXPECT_NEAR(huge.aspect_ratio[0] / 1e20, 1.0, 1e-9);
}

TEST(MeasureFaces, CollinearCornersHaveNoAreaAndInfiniteRatio) {
  const Soup soup =
      shapes::make({{0, 0, 0}, {0.1, 0.1, 0.1}, {0.7, 0.7, 0.7}, {0.1, 0.1, 0.1}, {1, 0, 0}},
                   {{0, 1, 2}, {0, 1, 4}, {1, 3, 4}});
  const FaceMeasures faces = measure(soup);
  EXPECT_EQ(faces.area[0], 0.0);
  EXPECT_EQ(faces.aspect_ratio[0], kInfinity);
  EXPECT_GT(faces.area[1], 0.0);
  EXPECT_EQ(faces.area[2], 0.0);
  EXPECT_EQ(faces.aspect_ratio[2], kInfinity);
  EXPECT_EQ(faces.zero_area, (std::vector<FaceHandle>{FaceHandle(0), FaceHandle(2)}));
}

TEST(MeasureFaces, ZeroAreaFacesOfManyChunksAreListedInOrder) {
  // 20,000 faces, each fifth flat.
  Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}, {});
  std::vector<FaceHandle> flat;
  for (int f = 0; f < 20000; ++f) {
    soup.triangles.push_back(f % 5 == 0 ? Triangle{0, 1, 3} : Triangle{0, 1, 2});
    if (f % 5 == 0) flat.emplace_back(f);
  }
  EXPECT_EQ(measure(soup).zero_area, flat);
}

TEST(MeasureFaces, AreasOfShapesAddUpToTheirFormulas) {
  for (const ShapeFigures& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    if (!shape.area) continue;
    const FaceMeasures faces = measure(shape.soup);
    EXPECT_NEAR(std::accumulate(faces.area.begin(), faces.area.end(), 0.0), *shape.area,
                1e-12 * *shape.area);
  }
}

TEST(MeasureFaces, ScalingMultipliesAreasAndKeepsRatios) {
  const Soup soup = shapes::torus(2, 0.5, 12, 8);
  const FaceMeasures before = measure(soup);
  const FaceMeasures after = measure(shapes::scaled(soup, 3.0));
  for (std::size_t f = 0; f < before.area.size(); ++f) {
    EXPECT_NEAR(after.area[f], 9 * before.area[f], 1e-12);
    EXPECT_NEAR(after.aspect_ratio[f], before.aspect_ratio[f], 1e-12);
  }
}

TEST(MeasureFaces, PowersOfTwoKeepRatiosAndAnglesToTheLastDigit) {
  const Soup soup = shapes::torus(2, 0.5, 12, 8);
  const FaceMeasures before = measure(soup);
  for (const int exponent : {-900, -500, -400, 400, 500, 1000}) {
    SCOPED_TRACE(exponent);
    const FaceMeasures after = measure(shapes::scaled(soup, std::ldexp(1.0, exponent)));
    EXPECT_EQ(after.aspect_ratio, before.aspect_ratio);
    EXPECT_EQ(after.corner_angle, before.corner_angle);
    EXPECT_TRUE(after.zero_area.empty());
    for (std::size_t f = 0; f < before.area.size(); ++f) {
      EXPECT_EQ(after.area[f], std::ldexp(before.area[f], 2 * exponent));
    }
  }
}

TEST(MeasureFaces, LargestDoublesHaveTheRatioOfTheirShape) {
  // Right triangles with legs 2 * 1.7e308, which overflow: the ratio of a half of a square is 2.
  const FaceMeasures faces = measure(shapes::cube(2.0, Vec3::Constant(-1.0)));
  const FaceMeasures huge =
      measure(shapes::scaled(shapes::cube(2.0, Vec3::Constant(-1.0)), 1.7e308));
  ASSERT_EQ(huge.aspect_ratio.size(), 12U);
  for (std::size_t f = 0; f < 12; ++f) {
    EXPECT_NEAR(faces.aspect_ratio[f], 2.0, 1e-12);
    EXPECT_NEAR(huge.aspect_ratio[f], 2.0, 1e-12);
    EXPECT_NEAR(huge.corner_angle[f], 45.0, 1e-12);
    EXPECT_EQ(huge.area[f], kInfinity);
  }
}

TEST(MeasureFaces, TinyFaceFarFromTheOriginHasTheRatioOfItsShape) {
  // Legs 1e-200 in the plane x = 1e100.
  const FaceMeasures faces =
      measure(shapes::make({{1e100, 0, 0}, {1e100, 1e-200, 0}, {1e100, 0, 1e-200}}, {{0, 1, 2}}));
  EXPECT_NEAR(faces.aspect_ratio[0], 2.0, 1e-12);
  EXPECT_NEAR(faces.corner_angle[0], 45.0, 1e-12);
}

TEST(MeasureFaces, RigidMotionKeepsAreasAndRatios) {
  const Soup soup = shapes::torus(2, 0.5, 12, 8);
  Soup moved = soup;
  const Eigen::AngleAxisd turn(0.7, Vec3(1, -2, 3).normalized());
  for (Vec3& p : moved.positions) p = turn * p + Vec3(5, 6, -7);
  const FaceMeasures before = measure(soup);
  const FaceMeasures after = measure(moved);
  for (std::size_t f = 0; f < before.area.size(); ++f) {
    EXPECT_NEAR(after.area[f], before.area[f], 1e-13);
    EXPECT_NEAR(after.aspect_ratio[f], before.aspect_ratio[f], 1e-12);
  }
}

}  // namespace
}  // namespace meshalyzer
