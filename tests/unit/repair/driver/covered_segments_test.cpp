#include "meshalyzer/repair/driver/internal/covered_segments.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <vector>

namespace meshalyzer {
namespace {

/// The faces that are left of all faces of a mesh.
std::vector<Index> left_of(const Soup& soup) {
  std::vector<ChangedFace> faces(soup.n_faces());
  for (Index face = 0; face < soup.n_faces(); ++face) faces[face].face = face;
  drop_covered_segments(soup, faces);
  std::vector<Index> left;
  for (const ChangedFace& changed : faces) left.push_back(changed.face);
  return left;
}

/// A fan round the first of n + 1 points on a line, each face of which has zero area.
Soup fan_on_a_line(Index n) {
  Soup soup;
  for (Index i = 0; i <= n; ++i) soup.positions.emplace_back(i, 2.0 * i, 0);
  for (Index i = 1; i < n; ++i) soup.triangles.push_back({0, i + 1, i});
  return soup;
}

TEST(DropCoveredSegments, OnlyTheLongestOfAFanOnALineIsLeft) {
  EXPECT_EQ(left_of(fan_on_a_line(9)), std::vector<Index>{7});
}

TEST(DropCoveredSegments, NoneIsLeftBesideATriangleWithTheWholeEdge) {
  Soup soup = fan_on_a_line(9);
  soup.positions.emplace_back(0, 0, 1);
  soup.triangles.push_back({10, 0, 9});
  EXPECT_EQ(left_of(soup), std::vector<Index>{8});
}

TEST(DropCoveredSegments, TheFirstOfEqualOnesIsLeft) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(left_of(shapes::make(points, {{0, 2, 1}, {0, 1, 2}, {2, 1, 0}})),
            std::vector<Index>{0});
  // Each lies on an edge of the other, whose other end is at the same position.
  EXPECT_EQ(left_of(shapes::make({{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {1, 0, 0}},
                                 {{0, 2, 1}, {1, 2, 0}, {0, 2, 3}})),
            std::vector<Index>{0});
}

TEST(DropCoveredSegments, WhatLiesOnNoEdgeIsLeft) {
  // The face of zero area has the shorter half of its length in common with a triangle.
  EXPECT_EQ(
      left_of(shapes::make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 2, 1}, {0, 1, 3}})),
      (std::vector<Index>{0, 1}));
  // A face that is a point has no edge.
  EXPECT_EQ(left_of(shapes::make({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}})),
            std::vector<Index>{0});
  EXPECT_EQ(left_of(shapes::icosphere(1)).size(), shapes::icosphere(1).n_faces());
}

}  // namespace
}  // namespace meshalyzer
