#include "meshalyzer/repair/folds/internal/fold_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace meshalyzer {
namespace {

const std::vector<Vec3> kSquare{{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};
/// An L of three squares: all of it is seen from the square in its bend only.
const std::vector<Vec3> kBend{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};

bool anything(Index, Index) {
  return true;
}

double area(const std::vector<Vec3>& outline, const std::vector<Triangle>& triangles) {
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles) {
    sum += (outline[b] - outline[a]).cross(outline[c] - outline[a])[2] / 2;
  }
  return sum;
}

TEST(MiddleOfKernel, OfAConvexOutlineIsItsMiddle) {
  EXPECT_NEAR((*middle_of_kernel(kSquare) - Vec3(1, 1, 1)).norm(), 0.0, 1e-12);
}

TEST(MiddleOfKernel, IsWhereAllIsSeenFrom) {
  EXPECT_NEAR((*middle_of_kernel(kBend) - Vec3(0.5, 0.5, 0)).norm(), 0.0, 1e-12);
}

TEST(MiddleOfKernel, OutlineThatIsSeenFromNowhereHasNone) {
  // A U.
  const std::vector<Vec3> bay{{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {2, 2, 0},
                              {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  EXPECT_FALSE(middle_of_kernel(bay));
  EXPECT_FALSE(middle_of_kernel(std::vector<Vec3>(4, Vec3::Zero())));
}

TEST(CutEars, TriangulatesAnOutlineThatIsNotConvex) {
  const std::vector<Triangle> triangles = cut_ears(kBend, anything);
  EXPECT_EQ(triangles.size(), 4U);
  EXPECT_DOUBLE_EQ(area(kBend, triangles), 3.0);
}

TEST(CutEars, LooksAlongTheNormal) {
  // The same outline, upright and the other way round in its projections.
  std::vector<Vec3> upright;
  for (const Vec3& p : kBend) upright.emplace_back(0.0, p[1], p[0]);
  const std::vector<Triangle> triangles = cut_ears(upright, anything);
  EXPECT_EQ(triangles.size(), 4U);
  for (const auto& [a, b, c] : triangles) {
    EXPECT_LT((upright[b] - upright[a]).cross(upright[c] - upright[a])[0], 0.0);
  }
}

TEST(CutEars, KeepsOffForbiddenEdges) {
  // One of the two diagonals of a square is left, then none.
  const auto only_one = [](Index a, Index b) { return a + b != 2; };
  const std::vector<Triangle> triangles = cut_ears(kSquare, only_one);
  ASSERT_EQ(triangles.size(), 2U);
  for (const Triangle& t : triangles) {
    EXPECT_TRUE(std::find(t.begin(), t.end(), 1U) != t.end());
    EXPECT_TRUE(std::find(t.begin(), t.end(), 3U) != t.end());
  }
  EXPECT_TRUE(cut_ears(kSquare, [](Index, Index) { return false; }).empty());
}

TEST(CutEars, ATriangleIsItself) {
  const std::vector<Vec3> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(cut_ears(triangle, [](Index, Index) { return false; }).size(), 1U);
}

TEST(ShapeQuality, OfAnEquilateralTriangleIsLargest) {
  EXPECT_NEAR(shape_quality({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, std::sqrt(0.75), 0)}),
              std::sqrt(0.75), 1e-15);
  EXPECT_EQ(shape_quality({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}), 0.0);
  EXPECT_EQ(shape_quality({Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1)}), 0.0);
}

}  // namespace
}  // namespace meshalyzer
