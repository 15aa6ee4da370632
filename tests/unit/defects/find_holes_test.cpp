#include "meshalyzer/defects/finders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace meshalyzer {
namespace {

using Edge = std::array<Index, 2>;

/// Finds holes as find_defects() does: slits first.
DefectList holes_of(const Soup& soup) {
  const PreparedMesh mesh(soup);
  return find_holes(mesh, find_slits(mesh, {.slit = 1e-9}));
}

TEST(FindHoles, ClosedMeshHasNone) {
  EXPECT_TRUE(holes_of(shapes::cube()).empty());
  EXPECT_TRUE(holes_of(shapes::two_tetrahedra_sharing_edge()).empty());
  EXPECT_TRUE(holes_of(Soup{}).empty());
}

TEST(FindHoles, MissingTopIsOneWithItsCentreAndLength) {
  const DefectList found = holes_of(shapes::open_cube());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, DefectCode::Hole);
  // In walking order round the top.
  EXPECT_EQ(found[0].edges, (std::vector<Edge>{{4, 5}, {4, 6}, {6, 7}, {5, 7}}));
  EXPECT_EQ(found[0].value, 4.0);
  ASSERT_EQ(found[0].positions.size(), 1U);
  EXPECT_EQ(found[0].positions[0], Vec3(0.5, 0.5, 1.0));
}

TEST(FindHoles, EachBoundaryIsOne) {
  const std::array<Index, 2> faces{0, 100};
  const DefectList found = holes_of(shapes::without_faces(shapes::uv_sphere(12, 12), faces));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_LT(found[0].edges.front(), found[1].edges.front());
}

TEST(FindHoles, BoundaryThatIsWhollyASlitIsNone) {
  // A cube cut open along one edge of its top: the faces there keep the vertices of their own side.
  Soup soup = shapes::grid(4, 4);
  // The edges (1,2)-(2,2)-(3,2) are cut: the faces above get a copy of the middle vertex.
  const auto copy = static_cast<Index>(soup.n_vertices());
  soup.positions.push_back(soup.positions[12]);
  for (Triangle& t : soup.triangles) {
    double y = 0.0;
    for (const Index v : t) y += soup.positions[v][1] / 3;
    if (y < 2.0) continue;
    for (Index& v : t) {
      if (v == 12) v = copy;
    }
  }
  const DefectList found = holes_of(soup);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].value, 16.0);
  // Opened, it is a hole like others.
  soup.positions[copy][1] += 0.1;
  const DefectList opened = holes_of(soup);
  ASSERT_EQ(opened.size(), 2U);
  EXPECT_EQ(opened[1].edges.size(), 4U);
}

TEST(FindHoles, BoundaryThatIsPartlyASlitIsOne) {
  const Soup soup =
      shapes::merged(shapes::grid(1, 1), shapes::translated(shapes::grid(1, 1), {1, 0, 0}));
  EXPECT_EQ(holes_of(soup).size(), 2U);
}

TEST(FindHoles, ChainBetweenNonManifoldEdgesIsOne) {
  EXPECT_EQ(holes_of(shapes::fan_of_three()).size(), 3U);
}

TEST(FindHoles, LengthSurvivesExtremeCoordinates) {
  const DefectList found = holes_of(shapes::scaled(shapes::open_cube(), 0x1p1000));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].value, 0x1p1002);
  EXPECT_EQ(found[0].positions[0], Vec3(0x1p999, 0x1p999, 0x1p1000));
}

}  // namespace
}  // namespace meshalyzer
