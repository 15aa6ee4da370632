#include "meshalyzer/spatial/closing_triangles.h"

#include "support/random_soups.h"
#include "support/shapes.h"
#include "support/triangles_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <random>
#include <utility>

namespace meshalyzer {
namespace {

/// How much oftener triangles run along each edge from its lower end than towards it, where that is
/// not 0, by the coordinates of the ends.
std::map<std::array<double, 6>, int> boundary_of(const std::vector<Corners>& triangles) {
  std::map<std::array<double, 6>, int> balance;
  for (const Corners& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& a = t[k];
      const Vec3& b = t[(k + 1) % 3];
      if (a == b) continue;
      const bool runs_up = std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
      const Vec3& low = runs_up ? a : b;
      const Vec3& high = runs_up ? b : a;
      balance[{low.x(), low.y(), low.z(), high.x(), high.y(), high.z()}] += runs_up ? 1 : -1;
    }
  }
  std::erase_if(balance, [](const auto& edge) { return edge.second == 0; });
  return balance;
}

std::size_t length_of(const std::map<std::array<double, 6>, int>& boundary) {
  std::size_t n = 0;
  for (const auto& [edge, count] : boundary) n += static_cast<std::size_t>(std::abs(count));
  return n;
}

void expect_closed(std::vector<Corners> triangles) {
  const std::size_t n_edges = length_of(boundary_of(triangles));
  const std::vector<Corners> closing = closing_triangles(triangles);
  EXPECT_LE(closing.size(), n_edges);
  triangles.insert(triangles.end(), closing.begin(), closing.end());
  EXPECT_TRUE(boundary_of(triangles).empty());
}

TEST(ClosingTriangles, ClosedSurfaceNeedsNone) {
  EXPECT_TRUE(closing_triangles({}).empty());
  EXPECT_TRUE(closing_triangles(test::triangles_of(shapes::icosphere(2))).empty());
}

TEST(ClosingTriangles, SquareHoleIsTwoTriangles) {
  const std::vector<Corners> box = test::triangles_of(shapes::open_cube());
  EXPECT_EQ(closing_triangles(box).size(), 2U);
  expect_closed(box);
}

TEST(ClosingTriangles, EqualPositionsAreOneVertex) {
  Soup unwelded;
  for (const Corners& t : test::triangles_of(shapes::cube())) {
    const auto first = static_cast<Index>(unwelded.positions.size());
    unwelded.positions.insert(unwelded.positions.end(), t.begin(), t.end());
    unwelded.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_TRUE(closing_triangles(test::triangles_of(unwelded)).empty());
}

TEST(ClosingTriangles, FaceTurnedOverIsGoneAlongTwice) {
  std::vector<Corners> cube = test::triangles_of(shapes::cube());
  std::swap(cube[0][1], cube[0][2]);
  EXPECT_EQ(length_of(boundary_of(cube)), 6U);
  expect_closed(cube);
}

TEST(ClosingTriangles, AnySoupIsClosed) {
  std::mt19937 random(5);
  for (int i = 0; i < 20; ++i) {
    expect_closed(test::triangles_of(damaged(shapes::torus(2, 1, 12, 8), 1 + i, random)));
  }
  expect_closed(test::triangles_of(shapes::grid(7, 3)));
}

TEST(ClosingTriangles, ReversedSurfaceHasThemReversed) {
  std::mt19937 random(6);
  for (int i = 0; i < 20; ++i) {
    std::vector<Corners> triangles =
        test::triangles_of(damaged(shapes::torus(2, 1, 12, 8), 1 + i, random));
    std::vector<Corners> closing = closing_triangles(triangles);
    for (Corners& t : triangles) std::swap(t[1], t[2]);
    for (Corners& t : closing) std::swap(t[1], t[2]);
    EXPECT_EQ(closing_triangles(triangles), closing);
  }
}

}  // namespace
}  // namespace meshalyzer
