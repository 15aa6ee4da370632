#include "meshalyzer/picture/internal/highlighted_elements.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace meshalyzer {
namespace {

TEST(FairShare, SmallSizesLeaveRoomForLargeOnes) {
  // 1 + 2 + 7 + 7 = 17, and one more for the large ones would be 19.
  EXPECT_EQ(fair_share(std::vector<std::size_t>{1, 2, 100, 50}, 1000, 18), 7U);
  EXPECT_EQ(fair_share(std::vector<std::size_t>{1, 2, 100, 50}, 1000, 19), 8U);
}

TEST(FairShare, LiesBetweenOneAndTheLimit) {
  EXPECT_EQ(fair_share(std::vector<std::size_t>{1, 2, 3}, 1000, 6), 1000U);
  EXPECT_EQ(fair_share(std::vector<std::size_t>{100, 100}, 30, 1000), 30U);
  EXPECT_EQ(fair_share(std::vector<std::size_t>(50, 10), 30, 7), 1U);
  EXPECT_EQ(fair_share({}, 30, 7), 30U);
}

TEST(HighlightedDefects, FirstOfEachCodeAreHighlighted) {
  Soup soup = shapes::cube();
  for (int i = 0; i < 5; ++i) soup.positions.emplace_back(i, 9, 9);
  soup = shapes::without_faces(soup, std::vector<Index>{0});
  const PreparedMesh mesh(soup);
  const DefectReport report = find_defects(mesh);
  const HighlightedDefects highlighted(mesh, report, {.max_defects_of_a_code = 3});
  std::vector<DefectCode> codes;
  for (const HighlightedElements& one : highlighted.all())
    codes.push_back(report.defects[one.number].code);
  EXPECT_EQ(codes, (std::vector<DefectCode>{DefectCode::Hole, DefectCode::OrphanVertex,
                                            DefectCode::OrphanVertex, DefectCode::OrphanVertex}));
}

TEST(HighlightedDefects, ComponentIsAllOfItsFaces) {
  const Soup soup = shapes::merged(shapes::icosphere(1), shapes::cube(0.1, Vec3(5, 5, 5)));
  const PreparedMesh mesh(soup);
  const DefectReport report = find_defects(mesh);
  const HighlightedDefects highlighted(mesh, report, {});
  ASSERT_EQ(highlighted.all().size(), 1U);
  const std::span<const Index> faces = highlighted.all()[0].faces;
  ASSERT_EQ(faces.size(), 12U);
  // After those of the icosphere.
  for (Index i = 0; i < 12; ++i) EXPECT_EQ(faces[i], 80 + i);
  EXPECT_FALSE(highlighted.all()[0].is_cut);
}

TEST(HighlightedDefects, LargeComponentIsCut) {
  const Soup soup = shapes::flipped(shapes::icosphere(3));
  const PreparedMesh mesh(soup);
  const DefectReport report = find_defects(mesh);
  ASSERT_EQ(report.count(DefectCode::Inward), 1U);
  const HighlightedDefects highlighted(mesh, report, {.max_elements_of_a_defect = 100});
  ASSERT_EQ(highlighted.all().size(), 1U);
  EXPECT_EQ(highlighted.all()[0].faces.size(), 100U);
  EXPECT_TRUE(highlighted.all()[0].is_cut);
}

TEST(HighlightedDefects, SeedsOfErrorsComeBeforeThoseOfWarnings) {
  // `disjoint`, a warning, is the first code; the small component is open, which is an error.
  const Soup soup =
      shapes::merged(shapes::icosphere(2), shapes::translated(shapes::grid(1, 1), Vec3(5, 0, 0)));
  const PreparedMesh mesh(soup);
  DefectReport report = find_defects(mesh);
  ASSERT_EQ(report.defects[0].code, DefectCode::Disjoint);
  Defect thin;
  thin.code = DefectCode::FlatFacet;
  thin.faces = {7};
  report.defects.push_back(thin);
  const HighlightedDefects highlighted(mesh, report, {});
  const Seeds seeds = highlighted.seeds(soup);
  EXPECT_EQ(seeds.faces, (std::vector<Index>{7, 320, 321}));
  EXPECT_EQ(seeds.vertices.size(), 8U);  // The ends of four border edges.
}

TEST(HighlightedDefects, SeedsOfLongDefectsLeaveRoomForShortOnes) {
  // The border of the square, of 80 edges, comes before that of the hole.
  const Soup soup = shapes::without_faces(shapes::grid(20, 20), std::vector<Index>{420});
  const PreparedMesh mesh(soup);
  const DefectReport report = find_defects(mesh);
  ASSERT_EQ(report.count(DefectCode::Hole), 2U);
  const Seeds seeds = HighlightedDefects(mesh, report, {}).seeds(soup);
  // Face 420 is the first of square (10, 10).
  const Index corner = 10 * 21 + 10;
  const auto place = std::find(seeds.vertices.begin(), seeds.vertices.end(), corner);
  EXPECT_LT(place - seeds.vertices.begin(), 12);
}

TEST(HighlightedDefects, FacesThatCannotBeDrawnAreNoSeeds) {
  Soup soup = shapes::cube();
  soup.triangles[3][0] = kNoIndex;
  soup.missing = {{3, 0, 99}};
  const PreparedMesh mesh(soup);
  const DefectReport report = find_defects(mesh, {.codes = {DefectCode::Corrupt}});
  ASSERT_EQ(report.defects.size(), 1U);
  EXPECT_TRUE(HighlightedDefects(mesh, report, {}).seeds(soup).faces.empty());
}

}  // namespace
}  // namespace meshalyzer
