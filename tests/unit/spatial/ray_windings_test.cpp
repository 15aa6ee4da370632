#include "meshalyzer/spatial/ray_windings.h"

#include "meshalyzer/spatial/closing_triangles.h"
#include "meshalyzer/spatial/winding_number.h"
#include "support/effort.h"
#include "support/random_soups.h"
#include "support/shapes.h"
#include "support/triangles_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>

namespace meshalyzer {
namespace {

constexpr double kNear = 0x1p-40;

std::optional<int> winding_at(const RayWindings& rays, const Vec3& point) {
  const auto both = rays.at_both(point, point);
  return both ? std::optional(both->front()) : std::nullopt;
}

Vec3 point_in_cube(std::mt19937& random, double half) {
  std::uniform_real_distribution<double> in_range(-half, half);
  const double x = in_range(random);
  const double y = in_range(random);
  return {x, y, in_range(random)};
}

TEST(RayWindings, NothingIsMetWhereNothingIs) {
  EXPECT_EQ(winding_at(RayWindings({}, kNear), {0, 0, 0}), 0);
}

TEST(RayWindings, CubeIsGoneRoundOnceInside) {
  const RayWindings cube(test::triangles_of(shapes::cube()), kNear);
  EXPECT_EQ(winding_at(cube, {0.25, 0.5, 0.75}), 1);
  EXPECT_EQ(winding_at(cube, {1.25, 0.5, 0.75}), 0);
  EXPECT_EQ(winding_at(cube, {-0.25, 0.5, 0.75}), 0);
  EXPECT_EQ(winding_at(cube, {0.5, 0.5, -0.1}), 0);
}

TEST(RayWindings, PointOnAFaceOrAnEdgeHasNoAnswer) {
  const RayWindings cube(test::triangles_of(shapes::cube()), kNear);
  EXPECT_EQ(winding_at(cube, {1.0, 0.25, 0.5}), std::nullopt);
  EXPECT_EQ(winding_at(cube, {1.0, 1.0, 0.5}), std::nullopt);
  EXPECT_EQ(winding_at(cube, {1.0 - 1e-14, 0.25, 0.5}), std::nullopt);
  EXPECT_EQ(winding_at(cube, {1.0 - 1e-11, 0.25, 0.5}), 1);
}

TEST(RayWindings, AgreeWithTheSumOfShares) {
  // Shares of directions of a closed surface add up to a whole number.
  std::mt19937 random(9);
  std::size_t n_answers = 0;
  std::size_t n_asked = 0;
  test::Effort effort;
  for (const Soup& soup :
       {shapes::icosphere(3), damaged(shapes::torus(0.5, 0.3, 40, 20), 8, random),
        damaged(shapes::icosphere(4), 20, random), damaged(shapes::icosphere(2), 60, random)}) {
    std::vector<Corners> triangles = test::triangles_of(soup);
    const std::vector<Corners> closing = closing_triangles(triangles);
    triangles.insert(triangles.end(), closing.begin(), closing.end());
    const RayWindings rays(triangles, kNear);
    for (int i = 0; i < 300; ++i) {
      const Vec3 point = point_in_cube(random, 1.2);
      if (!effort.runs_next()) continue;
      ++n_asked;
      const auto found = winding_at(rays, point);
      if (!found) continue;
      ++n_answers;
      EXPECT_NEAR(*found, WindingNumbers(triangles).at(point), 0.1);
    }
  }
  EXPECT_GT(n_answers, 99 * n_asked / 100);
}

}  // namespace
}  // namespace meshalyzer
