#include "meshalyzer/boolean/solid_fault.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <limits>

namespace meshalyzer {
namespace {

TEST(FindSolidFault, SolidsHaveNone) {
  EXPECT_EQ(find_solid_fault(shapes::cube()), "");
  EXPECT_EQ(find_solid_fault(shapes::nested_cubes(shapes::InnerShell::Cavity)), "");
  // Neither of which is manifold, or free of intersections.
  EXPECT_EQ(find_solid_fault(shapes::two_tetrahedra_sharing_edge()), "");
  EXPECT_EQ(find_solid_fault(shapes::merged(shapes::cube(2), shapes::cube(2, {1, 1, 1}))), "");
}

TEST(FindSolidFault, BordersAreCounted) {
  // The rim of the square that is missing.
  EXPECT_EQ(find_solid_fault(shapes::open_cube()), "it is not closed: 4 edges have one face only");
  EXPECT_EQ(find_solid_fault(shapes::fan_of_three()),
            "it is not closed: 6 edges have one face only");
}

TEST(FindSolidFault, FaceTurnedOverMakesItsEdgesUneven) {
  const std::vector<Index> one{4};
  EXPECT_EQ(find_solid_fault(shapes::flipped(shapes::cube(), one)),
            "its faces are not oriented alike: 3 edges are crossed more often in one direction "
            "than in the other");
}

TEST(FindSolidFault, ShellThatIsInsideOutIsNamed) {
  EXPECT_EQ(find_solid_fault(shapes::flipped(shapes::cube())), "it is inside out");
  EXPECT_EQ(
      find_solid_fault(shapes::merged(shapes::cube(), shapes::flipped(shapes::cube(1, {5, 0, 0})))),
      "one of its components is inside out");
  // Two tetrahedra with an edge in common are no shell.
  EXPECT_EQ(find_solid_fault(shapes::flipped(shapes::two_tetrahedra_sharing_edge())),
            "it encloses nothing, or is inside out");
}

TEST(FindSolidFault, ShellInsideOutThatCrossesAnotherTakesAwayFromIt) {
  EXPECT_EQ(find_solid_fault(
                shapes::merged(shapes::cube(2), shapes::flipped(shapes::cube(2, {1, 1, 1})))),
            "");
}

TEST(FindSolidFault, NothingEnclosedIsNoSolid) {
  EXPECT_EQ(find_solid_fault(Soup()), "it has no faces");
  EXPECT_EQ(find_solid_fault(shapes::pillow()), "it encloses nothing, or is inside out");
}

TEST(FindSolidFault, VertexThatIsMissingIsNamed) {
  Soup soup = shapes::cube();
  soup.triangles[3][1] = kNoIndex;
  soup.missing.push_back({3, 1, 99});
  EXPECT_EQ(find_solid_fault(soup), "its faces name vertices that are not there");
}

TEST(FindSolidFault, PositionThatIsNotFinite) {
  Soup soup = shapes::cube();
  soup.positions[1].z() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(find_solid_fault(soup), "it has a position that is not finite");
}

}  // namespace
}  // namespace meshalyzer
