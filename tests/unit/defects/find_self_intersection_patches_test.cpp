#include "meshalyzer/defects/finders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <vector>

namespace meshalyzer {
namespace {

DefectList patches_of(const Soup& soup) {
  return find_self_intersection_patches(PreparedMesh(soup));
}

/// Two faces that cross each other, the second through the middle of the first.
Soup crossing() {
  return shapes::make({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1.1, 1, 1}, {1, 1.1, 1}},
                      {{0, 1, 2}, {3, 4, 5}});
}

TEST(FindSelfIntersectionPatches, MeshWithoutHasNone) {
  EXPECT_TRUE(patches_of(shapes::cube()).empty());
  EXPECT_TRUE(patches_of(Soup{}).empty());
  EXPECT_TRUE(patches_of(shapes::translated(shapes::grid(2, 2), {0, 0, 1})).empty());
}

TEST(FindSelfIntersectionPatches, CrossingFacesAreOneThatIsFixable) {
  const DefectList found = patches_of(crossing());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, DefectCode::SelfIntersection);
  EXPECT_EQ(found[0].faces, (std::vector<Index>{0, 1}));
  EXPECT_EQ(found[0].pairs, (std::vector<IntersectingPair>{{0, 1, ContactKind::Crossing}}));
  EXPECT_EQ(found[0].value, 1.0);
  EXPECT_EQ(found[0].positions.size(), 1U);
  EXPECT_TRUE(found[0].fixable);
}

TEST(FindSelfIntersectionPatches, FacesThatAreApartAreSeveral) {
  const Soup soup = shapes::merged(crossing(), shapes::translated(crossing(), {10, 0, 0}));
  const DefectList found = patches_of(soup);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].faces, (std::vector<Index>{0, 1}));
  EXPECT_EQ(found[1].faces, (std::vector<Index>{2, 3}));
}

TEST(FindSelfIntersectionPatches, PairsWithACommonVertexAreOne) {
  // The first faces of both pairs have a corner in common; the pairs are far from each other.
  Soup soup = shapes::merged(crossing(), shapes::translated(crossing(), {4, 0, 0}));
  for (Triangle& t : soup.triangles) {
    for (Index& v : t) {
      if (v == 6) v = 1;
    }
  }
  const DefectList found = patches_of(soup);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].faces, (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(found[0].value, 2.0);
}

TEST(FindSelfIntersectionPatches, MattersOfOtherFixesAreFixable) {
  // Back to back on the same vertices.
  const DefectList duplicate = patches_of(shapes::pillow());
  ASSERT_EQ(duplicate.size(), 1U);
  EXPECT_TRUE(duplicate[0].fixable);
  // Two squares side by side that were never welded.
  const DefectList unwelded = patches_of(
      shapes::merged(shapes::grid(1, 1), shapes::translated(shapes::grid(1, 1), {1, 0, 0})));
  ASSERT_EQ(unwelded.size(), 1U);
  EXPECT_TRUE(unwelded[0].fixable);
  // Folded back on each other.
  const DefectList folded = patches_of(
      shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.7, 0}}, {{0, 1, 2}, {1, 0, 3}}));
  ASSERT_EQ(folded.size(), 1U);
  EXPECT_TRUE(folded[0].fixable);
}

TEST(FindSelfIntersectionPatches, PairsOfSeveralKindsAreOne) {
  Soup soup = crossing();
  soup.triangles.push_back({0, 1, 2});
  const DefectList found = patches_of(soup);
  ASSERT_EQ(found.size(), 1U);
  // 0 and 2 are the same face, and 1 crosses both.
  EXPECT_EQ(found[0].value, 3.0);
  EXPECT_TRUE(found[0].fixable);
}

TEST(FindSelfIntersectionPatches, FaceOfZeroAreaTakesPart) {
  Soup soup = crossing();
  soup.positions[5] = soup.positions[4];
  EXPECT_EQ(patches_of(soup).size(), 1U);
}

}  // namespace
}  // namespace meshalyzer
