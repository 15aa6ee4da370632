#include "meshalyzer/defects/finders.h"
#include "support/shapes.h"
#include "support/soups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace meshalyzer {
namespace {

using Edges = std::vector<std::array<Index, 2>>;

DefectList flipped_in(const Soup& soup) {
  return find_flipped(PreparedMesh(soup));
}

/// All the faces of the defects, ascending.
std::vector<Index> faces_of(const DefectList& defects) {
  std::vector<Index> faces;
  for (const Defect& defect : defects) {
    faces.insert(faces.end(), defect.faces.begin(), defect.faces.end());
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

TEST(FindFlipped, ConsistentMeshesHaveNone) {
  for (const Soup& soup : {Soup{}, shapes::cube(), shapes::flipped(shapes::cube()),
                           shapes::grid(3, 3), shapes::torus(2, 1, 8, 8)}) {
    EXPECT_TRUE(flipped_in(soup).empty());
  }
}

TEST(FindFlipped, OneFaceTurnedOverIsOnePatch) {
  const Soup cube = shapes::cube();
  const DefectList defects = flipped_in(shapes::flipped(cube, std::array{Index{7}}));
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_EQ(defects[0].code, DefectCode::Flipped);
  EXPECT_TRUE(defects[0].fixable);
  EXPECT_EQ(defects[0].faces, std::vector<Index>{7});
  Triangle t = cube.triangles[7];
  std::sort(t.begin(), t.end());
  EXPECT_EQ(defects[0].edges, (Edges{{t[0], t[1]}, {t[0], t[2]}, {t[1], t[2]}}));
  const Vec3 middle = (cube.positions[t[0]] + cube.positions[t[1]]) / 2;
  ASSERT_EQ(defects[0].positions.size(), 1U);
  EXPECT_EQ(defects[0].positions[0], middle);
}

TEST(FindFlipped, SmallerSideByAreaIsToBeTurnedThoughItHasMoreFaces) {
  // A square of two faces of area 1/2 and one of four faces on its edge, at a tenth of the area.
  const Soup soup = shapes::make(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1.01, 0.5, 0}, {1.01, 0, 0}, {1.01, 1, 0}},
      {{0, 1, 2}, {0, 2, 3}, {1, 2, 4}, {5, 1, 4}, {2, 6, 4}});
  const DefectList defects = flipped_in(soup);
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_EQ(defects[0].faces, (std::vector<Index>{2, 3, 4}));
  EXPECT_EQ(defects[0].edges, (Edges{{1, 2}}));
}

TEST(FindFlipped, OfEqualAreasTheSideWithFewerFacesIsToBeTurned) {
  // The middle of the upper half splits it in two; areas are 1 on either side.
  const Soup soup = shapes::make({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}, {1, 0.5, 0}},
                                 {{0, 1, 4}, {0, 4, 2}, {1, 2, 4}, {0, 1, 3}});
  EXPECT_EQ(faces_of(flipped_in(soup)), std::vector<Index>{3});
}

TEST(FindFlipped, OfEqualSidesTheOneWithTheLowestFaceStays) {
  const Soup soup =
      shapes::make({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}}, {{0, 1, 2}, {0, 1, 3}});
  EXPECT_EQ(faces_of(flipped_in(soup)), std::vector<Index>{1});
}

TEST(FindFlipped, EachPatchIsADefectOfItsOwnInOrder) {
  // Opposite corners of the grid are apart.
  const Soup soup = shapes::grid(4, 4);
  const auto last = static_cast<Index>(soup.n_faces() - 1);
  const DefectList defects = flipped_in(shapes::flipped(soup, std::array{last, Index{0}}));
  ASSERT_EQ(defects.size(), 2U);
  EXPECT_EQ(defects[0].faces, std::vector<Index>{0});
  EXPECT_EQ(defects[1].faces, std::vector<Index>{last});
}

TEST(FindFlipped, ComponentsAreJudgedEachByItself) {
  // All faces of the second cube but one are turned, so that one is to be turned.
  std::vector<Index> turned{3};
  for (Index f = 12; f < 24; ++f) {
    if (f != 20) turned.push_back(f);
  }
  const Soup soup = shapes::merged(shapes::cube(), shapes::cube(1.0, {5, 0, 0}));
  EXPECT_EQ(faces_of(flipped_in(shapes::flipped(soup, turned))), (std::vector<Index>{3, 20}));
}

TEST(FindFlipped, OneSidedComponentIsOneDefectThatNobodyCanFix) {
  const Soup soup = shapes::merged(shapes::moebius_strip(7), shapes::cube(1.0, {9, 0, 0}));
  const DefectList defects = flipped_in(soup);
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_FALSE(defects[0].fixable);
  EXPECT_EQ(defects[0].faces.size(), 14U);
  EXPECT_FALSE(defects[0].edges.empty());
}

TEST(FindFlipped, OneSidedComponentDoesNotHideOthers) {
  const Soup soup = shapes::merged(shapes::moebius_strip(7), shapes::cube(1.0, {9, 0, 0}));
  const DefectList defects = flipped_in(shapes::flipped(soup, std::array{Index{15}}));
  ASSERT_EQ(defects.size(), 2U);
  EXPECT_FALSE(defects[0].fixable);
  EXPECT_TRUE(defects[1].fixable);
  EXPECT_EQ(defects[1].faces, std::vector<Index>{15});
}

TEST(FindFlipped, EdgeOfThreeFacesAsksNothing) {
  EXPECT_TRUE(flipped_in(shapes::fan_of_three()).empty());
  EXPECT_TRUE(flipped_in(shapes::flipped(shapes::fan_of_three(), std::array{Index{0}})).empty());
}

TEST(FindFlipped, PartsThatOnlySuchAnEdgeJoinsAreJudgedEachByItself) {
  // Either tetrahedron has four faces; of the second three are turned.
  const Soup soup = shapes::two_tetrahedra_sharing_edge();
  const DefectList defects =
      flipped_in(shapes::flipped(soup, std::array{Index{4}, Index{5}, Index{6}}));
  for (const Index face : faces_of(defects)) EXPECT_GE(face, 4U);
  EXPECT_FALSE(defects.empty());
}

TEST(FindFlipped, FacesWithoutAreaGoByTheirNumber) {
  // Three faces in line with each other, the last turned.
  const Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}},
                                 {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {0, 0, 1}});
  const Soup turned = shapes::flipped(soup, std::array{Index{2}});
  EXPECT_EQ(faces_of(flipped_in(turned)), std::vector<Index>{2});
}

TEST(FindFlipped, CoordinatesTooLargeForAnAreaGoByTheNumberOfFaces) {
  const Soup soup = shapes::scaled(shapes::icosphere(1), 1e300);
  EXPECT_EQ(faces_of(flipped_in(shapes::flipped(soup, std::array{Index{2}, Index{40}}))),
            (std::vector<Index>{2, 40}));
}

TEST(FindFlipped, FewerThanHalfOfTheFacesTurnedAtRandomAreFound) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    for (const Soup& soup : {shapes::icosphere(2), shapes::torus(20, 1, 30, 3)}) {
      std::vector<Index> turned = shapes::permutation(soup.n_faces(), seed);
      turned.resize(turned.size() / 3);
      std::sort(turned.begin(), turned.end());
      EXPECT_EQ(faces_of(flipped_in(shapes::flipped(soup, turned))), turned);
    }
  }
}

}  // namespace
}  // namespace meshalyzer
