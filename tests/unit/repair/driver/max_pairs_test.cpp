#include "meshalyzer/repair/fix_defects.h"
#include "support/same_soup.h"
#include "support/shapes.h"
#include "unit/repair/repaired_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace meshalyzer {
namespace {

Soup cubes_that_cross() {
  return shapes::merged(shapes::cube(), shapes::cube(1.0, {0.5, 0.25, 0.375}));
}

/// Returns why defects of a code were left; empty if no reason was logged.
std::string reason_left(const RepairResult& result,
                        DefectCode code = DefectCode::SelfIntersection) {
  const auto& refusals = result.log.refusals;
  const auto refusal = std::find_if(refusals.begin(), refusals.end(),
                                    [&](const auto& logged) { return logged.code == code; });
  return refusal == refusals.end() ? "" : refusal->reason;
}

TEST(MaxPairs, MeshWithMorePairsIsLeftAndTheReasonSaid) {
  const Soup soup = cubes_that_cross();
  RepairOptions options;
  options.max_pairs = PreparedMesh(soup).intersecting_pairs().size();
  EXPECT_EQ(count_after(fix_defects(soup, options), DefectCode::SelfIntersection), 0U);

  *options.max_pairs -= 1;
  options.reports_patches = true;
  const RepairResult left = fix_defects(soup, options);
  EXPECT_TRUE(same_soup(only_mesh(left), soup));
  EXPECT_FALSE(left.is_stopped);
  EXPECT_NE(reason_left(left).find("pairs of faces intersect"), std::string::npos);
  ASSERT_FALSE(left.before.warnings.empty());
  EXPECT_NE(left.before.warnings.back().find("search"), std::string::npos);
  ASSERT_EQ(left.patches.size(), 1U);
  EXPECT_FALSE(left.patches.front().is_mended);
  EXPECT_EQ(left.patches.front().reason, reason_left(left));
}

TEST(MaxPairs, EqualFacesAreDroppedBeforeTheirPairsAreCounted) {
  Soup soup = shapes::cube();
  soup.triangles.resize(200, soup.triangles.back());
  RepairOptions options;
  options.max_pairs = 100;
  const RepairResult mended = fix_defects(soup, options);
  EXPECT_TRUE(same_soup(only_mesh(mended), shapes::cube()));

  // Where other pairs are left, everything stays.
  Soup crossing = cubes_that_cross();
  crossing.triangles.resize(200, crossing.triangles.back());
  options.max_pairs = 2;
  const RepairResult left = fix_defects(crossing, options);
  EXPECT_TRUE(same_soup(only_mesh(left), crossing));
  EXPECT_TRUE(left.log.steps.empty());
  EXPECT_FALSE(reason_left(left).empty());
}

TEST(MaxPairs, FarFacesThatAreClosedByThemselvesAreNotLost) {
  Soup soup = shapes::merged(shapes::cube(), shapes::translated(shapes::pillow(), {5, 0, 0}));
  const std::array<Triangle, 2> pillow{soup.triangles[12], soup.triangles[13]};
  for (int i = 0; i < 100; ++i) {
    soup.triangles.insert(soup.triangles.end(), pillow.begin(), pillow.end());
  }
  RepairOptions options;
  options.max_pairs = 100;
  const RepairResult result = fix_defects(soup, options);
  // The cube, and both sides of the triangle 4 units away.
  EXPECT_EQ(only_mesh(result).n_faces(), 14U);
  EXPECT_EQ(count_after(result, DefectCode::DuplicateFacet), 1U);
  EXPECT_TRUE(is_refused(result, DefectCode::DuplicateFacet, "farther than the maximum deviation"));
}

TEST(MaxPairs, BorderThatDroppingEqualFacesLeavesIsNamed) {
  // One triangle so often that each edge has 100 faces.
  Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  soup.triangles.resize(100, soup.triangles.front());
  RepairOptions options;
  options.max_pairs = 100;
  const RepairResult result = fix_defects(soup, options);
  EXPECT_EQ(only_mesh(result).n_faces(), 1U);
  ASSERT_EQ(result.rises.size(), 1U);
  EXPECT_EQ(result.rises[0].kind, CountedDefect::BorderEdges);
  EXPECT_EQ(result.rises[0].before, 0U);
  EXPECT_EQ(result.rises[0].after, 3U);
}

TEST(MaxPairs, RepairThatIsStoppedInTheFirstSearchLeavesTheMesh) {
  RepairOptions options;
  options.wants_to_stop = [] { return true; };
  const RepairResult result = fix_defects(cubes_that_cross(), options);
  EXPECT_TRUE(same_soup(only_mesh(result), cubes_that_cross()));
  EXPECT_TRUE(result.is_stopped);

  Soup equal_faces = shapes::cube();
  equal_faces.triangles.resize(200, equal_faces.triangles.back());
  const RepairResult stopped = fix_defects(equal_faces, options);
  EXPECT_TRUE(same_soup(only_mesh(stopped), equal_faces));
  EXPECT_NE(reason_left(stopped, DefectCode::DuplicateFacet).find("was stopped"),
            std::string::npos);
}

}  // namespace
}  // namespace meshalyzer
