#include "meshalyzer/repair/rules/internal/contact_rule.h"
#include "meshalyzer/repair/rules/internal/merge_rule.h"
#include "meshalyzer/repair/rules/internal/orientation_rule.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace meshalyzer {
namespace {

const Corners kTriangle{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};

TEST(AreInContact, FacesWithACommonVertexAloneAreNot) {
  const PlacedFace a{{0, 1, 2}, kTriangle};
  const PlacedFace b{{5, 0, 6}, {Vec3(-1, 0, 0), Vec3(0, 0, 0), Vec3(0, -1, 0)}};
  EXPECT_FALSE(are_in_contact(a, b));
  EXPECT_EQ(count_common_vertices(a, b), 1U);
}

TEST(AreInContact, FaceThatCrossesAnotherIs) {
  const PlacedFace a{{0, 1, 2}, kTriangle};
  const PlacedFace b{{3, 4, 5}, {Vec3(0.2, 0.2, -1), Vec3(0.2, 0.2, 1), Vec3(0.3, 0.2, 1)}};
  EXPECT_TRUE(are_in_contact(a, b));
  EXPECT_TRUE(are_in_contact_beyond_copies(a, b));
}

TEST(AreInContact, CopiesOfOneVertexTouchButCountAsNoContactBeyondThem) {
  const PlacedFace a{{0, 1, 2}, kTriangle};
  const PlacedFace b{{3, 4, 5}, {Vec3(0, 0, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0)}};
  EXPECT_TRUE(are_in_contact(a, b));
  EXPECT_FALSE(are_in_contact_beyond_copies(a, b));
}

TEST(AreInContact, CopiesOfAnEdgeCount) {
  const PlacedFace a{{0, 1, 2}, kTriangle};
  const PlacedFace b{{3, 4, 5}, {Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(0, -1, 0)}};
  EXPECT_TRUE(are_in_contact_beyond_copies(a, b));
}

TEST(KeepsOrientation, MovedCornerMayNotCrossTheEdgeOppositeOrReachIt) {
  EXPECT_TRUE(keeps_orientation(kTriangle, {kTriangle[0], kTriangle[1], Vec3(5, 1e-300, 7)}));
  EXPECT_FALSE(keeps_orientation(kTriangle, {kTriangle[0], kTriangle[1], Vec3(5, 0, 0)}));
  EXPECT_FALSE(keeps_orientation(kTriangle, {kTriangle[0], kTriangle[1], Vec3(0, -1, 0)}));
}

TEST(KeepsOrientation, FaceWithoutAreaMayBecomeAnything) {
  const Corners line{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)};
  EXPECT_TRUE(keeps_orientation(line, kTriangle));
}

/// Why one vertex must not be merged into another.
MergeRejection rejection(const Soup& soup, Index from, Index into) {
  std::vector<Index> representative(soup.n_vertices());
  std::iota(representative.begin(), representative.end(), Index{0});
  representative[from] = into;
  std::vector<Index> affected;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const Triangle& t = soup.triangles[f];
    const bool is_affected =
        std::any_of(t.begin(), t.end(), [&](Index v) { return v == from || v == into; });
    if (is_affected) affected.push_back(f);
  }
  const std::vector<MergeRejection> rejections = check_merges(soup, representative, affected);
  return rejections.empty() ? MergeRejection::None : rejections[into];
}

TEST(CheckMerges, EndsOfAnEdgeWouldCollapseItsFaces) {
  const Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  EXPECT_EQ(rejection(soup, 1, 0), MergeRejection::Collapse);
}

TEST(CheckMerges, VertexThatWouldCrossTheEdgeOppositeTurnsItsFaceOver) {
  const Soup soup = shapes::make(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {1, -2, 0}, {2, 0, 0}}, {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(rejection(soup, 2, 3), MergeRejection::TurnOver);
}

TEST(CheckMerges, FacesOnTheSameThreeVerticesAreDuplicates) {
  const Soup soup =
      shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {1, 0, 3}});
  EXPECT_EQ(rejection(soup, 3, 2), MergeRejection::Duplicate);
}

TEST(CheckMerges, ThirdFaceOnAnEdgeIsNonManifold) {
  // The edge 0 1 has two faces; the third has a copy of vertex 1.
  const Soup soup =
      shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                   {{0, 1, 2}, {1, 0, 3}, {0, 4, 5}});
  EXPECT_EQ(rejection(soup, 4, 1), MergeRejection::NonManifold);
}

TEST(CheckMerges, BordersThatCloseASlitAreAccepted) {
  const Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, -1, 0}},
                                 {{0, 1, 2}, {3, 0, 4}});
  EXPECT_EQ(rejection(soup, 3, 1), MergeRejection::None);
}

}  // namespace
}  // namespace meshalyzer
