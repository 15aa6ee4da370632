#include "meshalyzer/prepared/shells.h"

#include "meshalyzer/prepared/prepared_mesh.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <vector>

namespace meshalyzer {
namespace {

std::vector<std::uint8_t> shells_among(const Soup& soup) {
  const PreparedMesh mesh(soup);
  return which_are_shells(mesh.cut(), mesh.components());
}

using Flags = std::vector<std::uint8_t>;

TEST(WhichAreShells, ClosedComponentsAre) {
  EXPECT_EQ(shells_among(shapes::merged(shapes::cube(), shapes::tetrahedron())), Flags({1, 1}));
}

TEST(WhichAreShells, ComponentWithABorderIsNone) {
  Soup soup = shapes::cube();
  soup.triangles.pop_back();
  EXPECT_EQ(shells_among(shapes::merged(soup, shapes::cube())), Flags({0, 1}));
}

TEST(WhichAreShells, ComponentWithAFlippedFaceIsNone) {
  Soup soup = shapes::cube();
  std::swap(soup.triangles[0][0], soup.triangles[0][1]);
  EXPECT_EQ(shells_among(soup), Flags({0}));
}

TEST(WhichAreShells, ComponentThatIsNotManifoldIsNone) {
  EXPECT_EQ(shells_among(shapes::two_tetrahedra_sharing_vertex()), Flags({0}));
  EXPECT_EQ(shells_among(shapes::two_tetrahedra_sharing_edge()), Flags({0}));
}

TEST(FindShells, OpenSheetWithinAShellIsEnclosedButPointsNowhere) {
  // A triangle in the middle of a cube of side 3.
  const Soup sheet = shapes::make({{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}, {{0, 1, 2}});
  const Soup soup = shapes::merged(shapes::cube(3.0), sheet);
  const PreparedMesh mesh(soup);
  const std::vector<Shell> shells = find_shells(mesh);
  ASSERT_EQ(shells.size(), 2U);
  EXPECT_NEAR(shells[0].volume.value(), 27.0, 1e-13);
  EXPECT_EQ(shells[0].outward, true);
  EXPECT_EQ(shells[0].inside, kNoIndex);
  EXPECT_FALSE(shells[1].volume.has_value());
  EXPECT_FALSE(shells[1].outward.has_value());
  EXPECT_EQ(shells[1].inside, 0U);
}

}  // namespace
}  // namespace meshalyzer
