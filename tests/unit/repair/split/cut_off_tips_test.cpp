#include "meshalyzer/repair/passes.h"
#include "support/run_pass.h"
#include "support/shapes.h"
#include "unit/repair/repaired_meshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace meshalyzer {
namespace {

/// Two tetrahedra, each a corner of a cube, whose right-angled corners touch at the origin.
Soup touching_corners() {
  Soup mirrored = shapes::tetrahedron();
  for (Vec3& p : mirrored.positions) p = -p;
  return shapes::merged(shapes::tetrahedron(), shapes::flipped(mirrored));
}

const RepairLimits kLimits{.max_deviation = 0.1, .fixed_vertices = {}, .groups = Groups::Names};

/// Cuts off one tip of a mesh, which is good after that and was not before.
PassRun run_once(const Soup& soup) {
  EXPECT_FALSE(is_good(soup));
  PassRun run = run_pass(soup, cut_off_tips, kLimits);
  EXPECT_EQ(run.operations, 1U);
  EXPECT_TRUE(is_good(run.tracked.soup));
  return run;
}

TEST(CutOffTips, OneOfTwoCornersThatTouchIsCutOff) {
  const Soup soup = touching_corners();
  const PassRun run = run_once(soup);
  // Each edge of length 1 is cut off at a 512th of half of the deviation, and three faces are now
  // two, and a lid.
  EXPECT_EQ(run.tracked.soup.n_faces(), soup.n_faces() + 3 + 1);
  EXPECT_NEAR(volume_of(run.tracked.soup), (2 - std::pow(0.05 / 512, 3)) / 6, 1e-14);
  for (const Vec3& p : soup.positions) {
    // Only copies of the origin are gone.
    const auto& kept = run.tracked.soup.positions;
    EXPECT_NE(std::find(kept.begin(), kept.end(), p), kept.end());
  }
}

TEST(CutOffTips, TipsAreNoShorterThanFlatFacesAllow) {
  // Tips of a length of 0.05 / 512 and 0.05 / 64 would leave faces with a lower altitude.
  const PassRun run = run_pass(touching_corners(), cut_off_tips, kLimits, {.degeneracy = 0.001});
  EXPECT_EQ(run.operations, 1U);
  EXPECT_NEAR(volume_of(run.tracked.soup), (2 - std::pow(0.05 / 8, 3)) / 6, 1e-14);
}

/// A solid whose vertex at the origin is a saddle, touched there by the tip of a tetrahedron from
/// above.
Soup touched_saddle() {
  Soup saddle;
  saddle.positions = {{0, 0, 0},    {1, 0, 0.5},   {0, 1, -0.5},
                      {-1, 0, 0.5}, {0, -1, -0.5}, {0, 0, -3}};
  saddle.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1},
                      {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}};
  Soup tip;
  tip.positions = {{0, 0, 0}, {0.1, 0, 1}, {0, 0.1, 1}, {-0.1, -0.1, 1}};
  tip.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}};
  return shapes::merged(tip, saddle);
}

TEST(CutOffTips, SaddleIsClosedBesideTheTipThatTouchesIt) {
  const Soup soup = touched_saddle();
  const PassRun run = run_once(soup);
  // The lid has its diagonal between the valleys, so that it cuts off two tetrahedra; the other
  // diagonal would fill the valleys as much. The unit directions span 1 / sqrt(1.25)^3.
  const double cut_off = 2 * std::pow(0.05 / 512 / std::sqrt(1.25), 3) / 6;
  EXPECT_NEAR(volume_of(run.tracked.soup), volume_of(soup) - cut_off, 1e-14);
}

TEST(CutOffTips, MeshesWithoutContactsAreLeft) {
  for (const Soup& soup : {shapes::icosphere(1), shapes::nested_cubes(shapes::InnerShell::Cavity),
                           shapes::two_tetrahedra_sharing_vertex()}) {
    EXPECT_EQ(run_pass(soup, cut_off_tips).operations, 0U);
  }
}

TEST(CutOffTips, FixedVerticesStay) {
  const Soup soup = touching_corners();
  RepairLimits limits = kLimits;
  limits.fixed_vertices.assign(soup.n_vertices(), 1);
  EXPECT_EQ(run_pass(soup, cut_off_tips, limits).operations, 0U);
}

}  // namespace
}  // namespace meshalyzer
