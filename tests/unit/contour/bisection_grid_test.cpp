#include "meshalyzer/contour/bisection_grid.h"

#include "meshalyzer/base/error.h"
#include "support/random_soups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace meshalyzer {
namespace {

Box3 unit_box() {
  return {Vec3(0, 0, 0), Vec3(1, 1, 1)};
}

std::int64_t six_volumes(const GridTetrahedron& t) {
  Eigen::Matrix<std::int64_t, 3, 3> edges;
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(k);
      edges(i, k) = t.corners[static_cast<std::size_t>(i) + 1][at] - t.corners[0][at];
    }
  }
  return std::abs(edges.row(0).dot(edges.row(1).cross(edges.row(2))));
}

using Face = std::array<std::uint64_t, 3>;

/// Returns the number of tetrahedra at each face.
std::map<Face, int> faces_of(const BisectionGrid& grid) {
  std::map<Face, int> count;
  for (const Index number : grid.leaves()) {
    const GridTetrahedron& t = grid.tetrahedron(number);
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      Face face{};
      for (std::size_t i = 0; i < 3; ++i) face[i] = packed(t.corners[(left_out + 1 + i) % 4]);
      std::sort(face.begin(), face.end());
      ++count[face];
    }
  }
  return count;
}

bool is_on_one_side_of_the_cube(const Face& face) {
  for (std::size_t k = 0; k < 3; ++k) {
    for (const std::int32_t x : {0, BisectionGrid::kSize}) {
      if (std::all_of(face.begin(), face.end(),
                      [&](std::uint64_t p) { return unpacked(p)[k] == x; })) {
        return true;
      }
    }
  }
  return false;
}

/// Fails unless the tetrahedra fill the cube and meet face to face.
void expect_conforming(const BisectionGrid& grid) {
  const auto leaves = grid.leaves();
  const std::int64_t size = BisectionGrid::kSize;
  EXPECT_EQ(std::accumulate(leaves.begin(), leaves.end(), std::int64_t{0},
                            [&](std::int64_t sum, Index number) {
                              return sum + six_volumes(grid.tetrahedron(number));
                            }),
            6 * size * size * size);
  for (const auto& [face, n] : faces_of(grid)) {
    ASSERT_EQ(n, is_on_one_side_of_the_cube(face) ? 1 : 2);
  }
}

TEST(BisectionGrid, BeginsAsSixTetrahedraThatFillTheCube) {
  const BisectionGrid grid(unit_box());
  EXPECT_EQ(grid.leaves().size(), 6U);
  expect_conforming(grid);
}

TEST(BisectionGrid, HoldsItsBoxWithRoomToSpare) {
  for (const double size : {1.0, 1.9, 1e-20, 3e30}) {
    const Box3 box(Vec3(-size / 3, 0, size), Vec3(size / 3, size, 1.5 * size));
    const BisectionGrid grid(box);
    const std::int32_t end = BisectionGrid::kSize;
    EXPECT_TRUE(((box.min() - grid.place({0, 0, 0})).array() >= size / 16).all()) << size;
    EXPECT_TRUE(((grid.place({end, end, end}) - box.max()).array() >= size / 16).all()) << size;
  }
}

TEST(BisectionGrid, StaysConformingHoweverItIsRefined) {
  std::mt19937 random(20261122);
  for (int round = 0; round < 20; ++round) {
    BisectionGrid grid(unit_box());
    for (int i = 0; i < 60; ++i) {
      const auto leaves = grid.leaves();
      // Every third time near one place, so that levels differ much.
      grid.bisect(i % 3 == 0 ? grid.leaf_at({0.3, 0.4, 0.5})
                             : leaves[below(random, static_cast<Index>(leaves.size()))]);
    }
    expect_conforming(grid);
    EXPECT_EQ(grid.n_leaves(), grid.leaves().size());
  }
}

TEST(BisectionGrid, IsRefinedToItsFinestAtOnePlaceByFewTetrahedra) {
  BisectionGrid grid(unit_box());
  const Vec3 place(0.71, 0.22, 0.13);
  while (grid.tetrahedron(grid.leaf_at(place)).level < BisectionGrid::kMaxLevel)
    grid.bisect(grid.leaf_at(place));
  grid.bisect(grid.leaf_at(place));
  EXPECT_LT(grid.leaves().size(), 10'000U);
  expect_conforming(grid);
}

TEST(BisectionGrid, FindsTheTetrahedronThatHoldsAPlace) {
  std::mt19937 random(7);
  BisectionGrid grid(unit_box());
  for (int i = 0; i < 200; ++i) {
    const Vec3 place = Vec3(below(random, 1000), below(random, 1000), below(random, 1000)) / 1000;
    const Index number = grid.leaf_at(place);
    const GridTetrahedron t = grid.tetrahedron(number);
    const Vec3 p = (place - grid.origin()) / grid.step();
    std::array<Vec3, 4> c;
    for (std::size_t k = 0; k < 4; ++k)
      c[k] = (grid.place(t.corners[k]) - grid.origin()) / grid.step();
    Eigen::Matrix3d edges;
    edges << c[1] - c[0], c[2] - c[0], c[3] - c[0];
    const Vec3 shares = edges.inverse() * (p - c[0]);
    EXPECT_GE(shares.minCoeff(), -1e-9);
    EXPECT_LE(shares.sum(), 1 + 1e-9);
    grid.bisect(number);
  }
}

TEST(BisectionGrid, RefusesABoxWithoutExtentOrTooFarAwayForItsSize) {
  EXPECT_THROW(BisectionGrid{Box3()}, InvalidArgument);
  EXPECT_THROW(BisectionGrid(Box3(Vec3(1, 2, 3), Vec3(1, 2, 3))), InvalidArgument);
  EXPECT_THROW(BisectionGrid(Box3(Vec3(1e14, 0, 0), Vec3(1e14 + 1, 1, 1))), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
