#include "support/shapes.h"
#include "unit/repair/holes/hole_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace meshalyzer {
namespace {

/// The faces of a sphere between two heights.
Soup zone_of_sphere(double low, double high) {
  const Soup sphere = shapes::icosphere(4);
  std::vector<Index> outside;
  for (Index f = 0; f < sphere.n_faces(); ++f) {
    const Triangle& t = sphere.triangles[f];
    const double height =
        (sphere.positions[t[0]] + sphere.positions[t[1]] + sphere.positions[t[2]]).z() / 3.0;
    if (height < low || height > high) outside.push_back(f);
  }
  return shapes::without_faces(sphere, outside);
}

TEST(FillHoles, FillsRoundAnIslandOfASphere) {
  // The patch over the whole hole is no nearer to the island than to the sphere. The last island is
  // a band, whose other border runs as that of the hole does.
  struct Heights {
    double hole, island_low, island_high;
  };
  for (const Heights& z :
       {Heights{0.7, 0.95, 1.0}, {0.5, 0.9, 1.0}, {0.6, 0.8, 1.0}, {0.5, 0.65, 0.85}}) {
    SCOPED_TRACE(z.island_low);
    const Soup open =
        shapes::merged(zone_of_sphere(-1.0, z.hole), zone_of_sphere(z.island_low, z.island_high));
    const PassRun run = fill(open, {});
    expect_filled(run.tracked.soup);
    EXPECT_TRUE(keeps_input(open, run.tracked));
    EXPECT_EQ(analyze(run.tracked.soup, "").characteristics.components, 1U);
    for (std::size_t v = open.n_vertices(); v < run.tracked.soup.n_vertices(); ++v) {
      EXPECT_NEAR(run.tracked.soup.positions[v].norm(), 1.0, 0.02);
    }
  }
}

/// Several zones of a sphere as one soup, by the heights of their borders from below.
Soup zones_of_sphere(const std::vector<std::array<double, 2>>& heights) {
  Soup zones;
  for (const auto& [low, high] : heights) {
    zones = shapes::merged(zones, zone_of_sphere(low, high));
  }
  return zones;
}

TEST(FillHoles, FillsTheGapsBetweenNestedBandsOneByOne) {
  // Each gap has the upper border of one band and the lower one of the next, so that all bands make
  // one sphere with a cap.
  const std::vector<std::vector<std::array<double, 2>>> cases{
      {{-1.0, 0.3}, {0.55, 0.7}, {0.85, 0.94}},
      {{-1.0, -0.1}, {0.1, 0.25}, {0.6, 0.75}},
      {{-1.0, 0.0}, {0.2, 0.35}, {0.55, 0.7}, {0.85, 0.93}}};
  for (const auto& heights : cases) {
    SCOPED_TRACE(heights.size());
    const Soup open = zones_of_sphere(heights);
    const PassRun run = fill(open, {});
    expect_filled(run.tracked.soup);
    EXPECT_TRUE(keeps_input(open, run.tracked));
    EXPECT_EQ(analyze(run.tracked.soup, "").characteristics.components, 1U);
    for (std::size_t v = open.n_vertices(); v < run.tracked.soup.n_vertices(); ++v) {
      EXPECT_NEAR(run.tracked.soup.positions[v].norm(), 1.0, 0.02);
    }
  }
}

TEST(FillHoles, JoinsAnIslandATenthOfTheRadiusOffTheSurface) {
  for (const double factor : {0.9, 1.1}) {
    SCOPED_TRACE(factor);
    const Soup open = shapes::merged(zone_of_sphere(-1.0, 0.65),
                                     shapes::scaled(zone_of_sphere(0.96, 1.0), factor));
    const PassRun run = fill(open, {});
    expect_filled(run.tracked.soup);
    EXPECT_EQ(analyze(run.tracked.soup, "").characteristics.components, 1U);
    // The patch goes from the sphere to the island, and hardly beyond either: a tenth of the
    // difference for the bulge of a surface that is tangent to both.
    for (std::size_t v = open.n_vertices(); v < run.tracked.soup.n_vertices(); ++v) {
      const double radius = run.tracked.soup.positions[v].norm();
      EXPECT_GT(radius, std::min(1.0, factor) - 0.02);
      EXPECT_LT(radius, std::max(1.0, factor) + 0.02);
    }
  }
}

TEST(FillHoles, JoinsIslandsBesideEachOtherAndInRings) {
  // A hole above z = 0.2 with a ring round a direction and a disc in it, and another disc beside.
  const Soup sphere = shapes::icosphere(4);
  const Vec3 ring = Vec3(1.0, 0.0, 1.5).normalized();
  const Vec3 disc = Vec3(-1.0, 0.0, 1.5).normalized();
  std::vector<Index> lost;
  for (Index f = 0; f < sphere.n_faces(); ++f) {
    const Triangle& t = sphere.triangles[f];
    const Vec3 middle =
        (sphere.positions[t[0]] + sphere.positions[t[1]] + sphere.positions[t[2]]) / 3.0;
    const double from_ring = (middle - ring).norm();
    const bool stays = middle.z() < 0.2 || (middle - disc).norm() < 0.25 || from_ring < 0.1 ||
                       (from_ring > 0.22 && from_ring < 0.36);
    if (!stays) lost.push_back(f);
  }
  const Soup open = shapes::without_faces(sphere, lost);
  const PassRun run = fill(open, {});
  expect_filled(run.tracked.soup);
  EXPECT_EQ(analyze(run.tracked.soup, "").characteristics.components, 1U);
}

TEST(FillHoles, LeavesAnIslandThatPointsTheOtherWay) {
  const Soup island = shapes::flipped(zone_of_sphere(0.95, 1.0));
  const PassRun run = fill(shapes::merged(zone_of_sphere(-1.0, 0.7), island), {});
  EXPECT_EQ(run.operations, 1U);
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(analyze(run.tracked.soup, "").characteristics.components, 2U);
}

}  // namespace
}  // namespace meshalyzer
