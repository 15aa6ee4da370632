#include "meshalyzer/defects/finders.h"
#include "support/foldovers.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

using shapes::grid_vertex;

DefectList foldovers_of(const Soup& soup, const Tolerances& tolerances) {
  return find_foldovers(PreparedMesh(soup), tolerances);
}

DefectList foldovers_of(const Soup& soup) {
  return foldovers_of(soup, {.height = 1e-7, .max_foldover_angle = 1.0});
}

/// Faces of a soup in the plane z = 0 that look down, counted by their signed area.
std::vector<Index> faces_turned_over(const Soup& soup) {
  std::vector<Index> faces;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const auto& [a, b, c] = soup.triangles[f];
    const Vec3 u = soup.positions[b] - soup.positions[a];
    const Vec3 v = soup.positions[c] - soup.positions[a];
    if (u.cross(v)[2] < 0.0) faces.push_back(f);
  }
  return faces;
}

/// Turned and moved, so that no coordinate is round.
Soup tilted(Soup soup) {
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  for (Vec3& p : soup.positions) p = turn * p + Vec3(10.3, -4.7, 2.9);
  return soup;
}

TEST(FindFoldovers, FlatSheetHasNone) {
  EXPECT_TRUE(foldovers_of(shapes::grid(4, 4)).empty());
  EXPECT_TRUE(foldovers_of(shapes::cube()).empty());
  EXPECT_TRUE(foldovers_of(Soup{}).empty());
}

TEST(FindFoldovers, VertexDraggedOverAnEdgeOfItsRingMakesOne) {
  const Soup soup = shapes::dragged_vertex();
  const std::vector<Index> turned = faces_turned_over(soup);
  ASSERT_EQ(turned.size(), 1U);
  for (const Soup& sheet : {soup, tilted(soup), shapes::flipped(soup)}) {
    const DefectList found = foldovers_of(sheet);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].code, DefectCode::Foldover);
    EXPECT_EQ(found[0].faces, turned);
    const Index v = grid_vertex(5, 2, 2);
    const Index a = grid_vertex(5, 3, 2);
    const Index b = grid_vertex(5, 3, 3);
    EXPECT_EQ(found[0].edges, (std::vector<std::array<Index, 2>>{{v, a}, {v, b}, {a, b}}));
    EXPECT_LE(*found[0].value, 1e-14);
    EXPECT_EQ(found[0].limit, 1e-7);
    EXPECT_EQ(found[0].positions.size(), 1U);
  }
}

TEST(FindFoldovers, HeapOfOtherFacesOnTheSameSpotHidesNone) {
  const Soup sheet = shapes::dragged_vertex();
  // Its middle is within the face that is turned over and the one below it.
  const Vec3 middle = foldovers_of(sheet)[0].positions[0];
  Soup soup;
  for (int i = 0; i < 3000; ++i) {
    const auto first = static_cast<Index>(soup.n_vertices());
    for (const Vec3& corner : {Vec3(-0.01, -0.01, 0), Vec3(0.02, -0.01, 0), Vec3(0, 0.02, 0)}) {
      soup.positions.push_back(middle + corner);
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_TRUE(foldovers_of(soup).empty());
  const auto n_heap = static_cast<Index>(soup.n_vertices());
  soup.positions.insert(soup.positions.end(), sheet.positions.begin(), sheet.positions.end());
  for (const Triangle& t : sheet.triangles) {
    soup.triangles.push_back({t[0] + n_heap, t[1] + n_heap, t[2] + n_heap});
  }
  EXPECT_EQ(foldovers_of(soup).size(), 1U);
}

TEST(FindFoldovers, DoesNotDependOnTheOrderOfFaces) {
  const Soup soup = shapes::shuffled_faces(shapes::dragged_vertex(), 7);
  const DefectList found = foldovers_of(soup);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].faces, faces_turned_over(soup));
}

TEST(FindFoldovers, AngleAboveTheLimitIsNoFold) {
  // The vertex is lifted 0.1 tan(2 degrees) above the plane, 0.1 beyond the edge: there the angle
  // is 2 degrees, and without that fold nothing bounds the region. The faces beyond the two other
  // folds have the vertex 0.28 and 0.5 from their edges in the plane: they rise by 0.7 degrees at
  // most, so that these folds have less than 3.
  const Soup soup = shapes::dragged_vertex(0.1 * std::tan(2.0 * std::numbers::pi / 180.0));
  EXPECT_TRUE(foldovers_of(soup, {.height = 1.0, .max_foldover_angle = 1.9}).empty());
  EXPECT_EQ(foldovers_of(soup, {.height = 1.0, .max_foldover_angle = 3.0}).size(), 1U);
}

TEST(FindFoldovers, HeightAboveTheToleranceIsNone) {
  // Lifted by h = 0.0005, which at 0.1 beyond the edge is 0.29 degrees. All of the region is within
  // h of the plane. Its middle is h / 3 above the plane, and farther below the sheets over it,
  // whose edge is at the height of the vertex.
  const Soup soup = shapes::dragged_vertex(0.0005);
  EXPECT_EQ(foldovers_of(soup, {.height = 0.0005, .max_foldover_angle = 1.0}).size(), 1U);
  EXPECT_TRUE(foldovers_of(soup, {.height = 0.0001, .max_foldover_angle = 1.0}).empty());
}

TEST(FindFoldovers, ValueIsWithinTheToleranceAndAboveWhatIsThere) {
  const DefectList found =
      foldovers_of(shapes::dragged_vertex(0.0005), {.height = 0.001, .max_foldover_angle = 1.0});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_GE(*found[0].value, 0.0001);
  EXPECT_LE(*found[0].value, 0.001);
}

TEST(FindFoldovers, FoldedFlatIsOneAtAnAngleOfZero) {
  EXPECT_EQ(
      foldovers_of(shapes::dragged_vertex(), {.height = 0.0, .max_foldover_angle = 0.0}).size(),
      1U);
  EXPECT_TRUE(foldovers_of(shapes::dragged_vertex(1e-5), {.height = 1.0, .max_foldover_angle = 0.0})
                  .empty());
}

TEST(FindFoldovers, RandomlyDraggedVertexTurnsOverJustTheFacesFound) {
  std::mt19937 random(11);
  for (int i = 0; i < 300; ++i) {
    Soup soup = shapes::grid(6, 6);
    const auto somewhere = [&] { return 0.5 + below(random, 5001) * 0.001 + 1e-5; };
    soup.positions[grid_vertex(6, 3, 3)] = {somewhere(), somewhere() + 0.00037, 0.0};
    std::vector<Index> found;
    for (const Defect& defect : foldovers_of(soup)) {
      found.insert(found.end(), defect.faces.begin(), defect.faces.end());
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, faces_turned_over(soup)) << soup.positions[grid_vertex(6, 3, 3)];
  }
}

TEST(FindFoldovers, CornerFoldedOverIsOne) {
  const Soup soup = shapes::dog_ear();
  const DefectList found = foldovers_of(soup);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].faces, faces_turned_over(soup));
  EXPECT_EQ(found[0].edges.size(), 1U);
}

TEST(FindFoldovers, MiddleSheetOfThreeIsTheOne) {
  // From 0 to 6, back to 4, and on to 8: sheets of 6, 2 and 4 squares' length.
  const Soup soup = shapes::folded_strip(12, std::array{6.0, 8.0});
  const DefectList found = foldovers_of(soup);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].faces, faces_turned_over(soup));
  EXPECT_EQ(found[0].faces.size(), 8U);
  EXPECT_EQ(found[0].edges.size(), 4U);
}

TEST(FindFoldovers, ShorterEndOfAFoldedStripIsTheOne) {
  const DefectList found = foldovers_of(shapes::folded_strip(7, std::array{5.0}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].faces.size(), 8U);
}

TEST(FindFoldovers, HemFoldedTwiceIsTwo) {
  // 1 on 2 on 9: the first lies on the second, which lies on the rest.
  const DefectList found = foldovers_of(shapes::folded_strip(12, std::array{9.0, 11.0}));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].faces.size() + found[1].faces.size(), 12U);
}

TEST(FindFoldovers, SheetsThatLieOnEachOtherEverywhereHaveNone) {
  EXPECT_TRUE(foldovers_of(shapes::pillow()).empty());
  EXPECT_TRUE(foldovers_of(shapes::folded_strip(6, std::array{3.0})).empty());
  EXPECT_TRUE(foldovers_of(shapes::folded_strip(6, std::array{2.0, 4.0})).empty());
  Soup plate = shapes::cube();
  for (Vec3& p : plate.positions) p[2] *= 1e-9;
  EXPECT_TRUE(foldovers_of(plate).empty());
}

TEST(FindFoldovers, FinHasTipsButIsBoundByNoChain) {
  // A wall of no thickness on a floor: its two sides fold at the top, but both go on into the
  // floor, so that the folds bound nothing.
  Soup soup = shapes::grid(4, 2);
  for (Vec3& p : soup.positions) {
    if (p[0] == 2.0) p[2] = 1.0;
    if (p[0] == 3.0) p[0] = 1.0;
    if (p[0] == 4.0) p[0] = 2.0;
  }
  EXPECT_TRUE(foldovers_of(soup, {.height = 1e-7, .max_foldover_angle = 1.0}).empty());
}

TEST(FindFoldovers, FlapThatTurnsUpAgainIsNone) {
  // Folded over at x = 6, up at x = 4 by 0.1, and on to x = 5, where it faces up as the floor does.
  Soup soup = shapes::grid(10, 1);
  const std::array<std::array<double, 2>, 5> places{{{6, 0}, {5, 0}, {4, 0}, {4, 0.1}, {5, 0.1}}};
  for (Vec3& p : soup.positions) {
    if (p[0] < 6.0) continue;
    const auto& [x, z] = places[static_cast<std::size_t>(p[0]) - 6];
    p = {x, p[1], z};
  }
  EXPECT_TRUE(foldovers_of(soup, {.height = 0.2, .max_foldover_angle = 1.0}).empty());
}

TEST(FindFoldovers, FaceOfZeroAreaIsNone) {
  // Dragged just onto the edge.
  Soup soup = shapes::grid(5, 4);
  soup.positions[grid_vertex(5, 2, 2)] = {3.0, 2.5, 0.0};
  EXPECT_TRUE(foldovers_of(soup).empty());
}

TEST(FindFoldovers, SurvivesExtremeCoordinates) {
  for (const double factor : {1e-320, 1e-160, 1e160, 1e307}) {
    const Soup soup = shapes::scaled(shapes::dragged_vertex(), factor);
    EXPECT_LE(foldovers_of(soup, {.height = factor, .max_foldover_angle = 1.0}).size(), 1U);
  }
}

TEST(FindFoldovers, ToleranceBeyondTheMeshEndsSoon) {
  // With everything within the tolerance only opposed normals tell.
  const DefectList found =
      foldovers_of(shapes::dragged_vertex(), {.height = 100.0, .max_foldover_angle = 1.0});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].faces, faces_turned_over(shapes::dragged_vertex()));
}

}  // namespace
}  // namespace meshalyzer
