#include "meshalyzer/defects/finders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

DefectList disjoint_in(const Soup& soup) {
  return find_disjoint(PreparedMesh(soup));
}

TEST(FindDisjoint, OneComponentIsNone) {
  EXPECT_TRUE(disjoint_in(shapes::cube()).empty());
  EXPECT_TRUE(disjoint_in({}).empty());
}

TEST(FindDisjoint, ComponentsThatTouchAtAVertexAreOne) {
  EXPECT_TRUE(disjoint_in(shapes::two_tetrahedra_sharing_vertex()).empty());
}

TEST(FindDisjoint, AllButTheLargestAreNamedByTheirFirstFace) {
  // Faces 0-3 a tetrahedron, 4-15 a cube, 16-19 a tetrahedron.
  const Soup soup =
      shapes::merged(shapes::merged(shapes::tetrahedron(), shapes::cube(1.0, Vec3(5, 0, 0))),
                     shapes::translated(shapes::tetrahedron(), Vec3(9, 0, 0)));
  const DefectList defects = disjoint_in(soup);
  ASSERT_EQ(defects.size(), 2U);
  EXPECT_EQ(defects[0].code, DefectCode::Disjoint);
  EXPECT_EQ(defects[0].severity, Severity::Warning);
  EXPECT_EQ(defects[0].faces, std::vector<Index>{0});
  EXPECT_EQ(defects[0].value, 4.0);
  EXPECT_FALSE(defects[0].limit);
  EXPECT_EQ(defects[1].faces, std::vector<Index>{16});
  EXPECT_EQ(defects[1].value, 4.0);
  ASSERT_EQ(defects[1].positions.size(), 1U);
  EXPECT_GE(defects[1].positions[0].x(), 9.0);
}

TEST(FindDisjoint, OfEqualComponentsTheFirstIsTheLargest) {
  const Soup soup = shapes::merged(shapes::cube(), shapes::cube(1.0, Vec3(5, 0, 0)));
  const DefectList defects = disjoint_in(soup);
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_EQ(defects[0].faces, std::vector<Index>{12});
}

TEST(FindDisjoint, FacesAreNamedAsInTheFileWhereSomeAreNotInTheComplex) {
  Soup soup = shapes::tetrahedron();
  soup.triangles.insert(soup.triangles.begin(), Triangle{0, 0, 1});
  soup = shapes::merged(soup, shapes::cube(1.0, Vec3(5, 0, 0)));
  const DefectList defects = disjoint_in(soup);
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_EQ(defects[0].faces, std::vector<Index>{1});
}

}  // namespace
}  // namespace meshalyzer
