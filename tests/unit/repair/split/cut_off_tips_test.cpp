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

TEST(CutOffTips, OneOfTwoCornersThatTouchIsCutOff) {
  const Soup soup = touching_corners();
  ASSERT_FALSE(is_good(soup));
  const RepairLimits limits{.max_deviation = 0.1, .fixed_vertices = {}, .groups = Groups::Names};
  const PassRun run = run_pass(soup, cut_off_tips, limits);
  EXPECT_EQ(run.operations, 1U);
  EXPECT_TRUE(is_good(run.tracked.soup));
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
  const Soup soup = touching_corners();
  const RepairLimits limits{.max_deviation = 0.1, .fixed_vertices = {}, .groups = Groups::Names};
  // Tips of a length of 0.05 / 512 and 0.05 / 64 would leave faces with a lower altitude.
  const PassRun run = run_pass(soup, cut_off_tips, limits, {.degeneracy = 0.001});
  EXPECT_EQ(run.operations, 1U);
  EXPECT_NEAR(volume_of(run.tracked.soup), (2 - std::pow(0.05 / 8, 3)) / 6, 1e-14);
}

TEST(CutOffTips, MeshesWithoutContactsAreLeft) {
  for (const Soup& soup : {shapes::icosphere(1), shapes::nested_cubes(shapes::InnerShell::Cavity),
                           shapes::two_tetrahedra_sharing_vertex()}) {
    EXPECT_EQ(run_pass(soup, cut_off_tips).operations, 0U);
  }
}

TEST(CutOffTips, FixedVerticesStay) {
  const Soup soup = touching_corners();
  RepairLimits limits{.max_deviation = 0.1, .fixed_vertices = {}, .groups = Groups::Names};
  limits.fixed_vertices.assign(soup.n_vertices(), 1);
  EXPECT_EQ(run_pass(soup, cut_off_tips, limits).operations, 0U);
}

}  // namespace
}  // namespace meshalyzer
