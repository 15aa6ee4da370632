#include "meshalyzer/spatial/faces_near.h"

#include "support/constants.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <vector>

namespace meshalyzer {
namespace {

std::vector<Index> faces_near(const Soup& soup, const std::vector<Box3>& boxes) {
  return find_faces_near(soup, boxes);
}

/// A tetrahedron at 0 0 0, and one at 10 10 10, of four faces each.
Soup two_tetrahedra() {
  return shapes::merged(shapes::tetrahedron(),
                        shapes::translated(shapes::tetrahedron(), {10, 10, 10}));
}

TEST(FindFacesNear, NoBoxAndEmptyOnesAreNearNothing) {
  EXPECT_TRUE(faces_near(two_tetrahedra(), {}).empty());
  EXPECT_TRUE(faces_near(two_tetrahedra(), {Box3(), Box3()}).empty());
}

TEST(FindFacesNear, FacesOfTheTetrahedronInTheBoxAreFound) {
  const Box3 first(Vec3(-1, -1, -1), Vec3(2, 2, 2));
  EXPECT_EQ(faces_near(two_tetrahedra(), {first, Box3()}), (std::vector<Index>{0, 1, 2, 3}));
}

TEST(FindFacesNear, BoxesMayBeInfiniteOrAsLargeAsDoublesAre) {
  for (const double far : {kInfinity, std::numeric_limits<double>::max()}) {
    const Box3 half_space(Vec3(5, -far, -far), Vec3::Constant(far));
    EXPECT_EQ(faces_near(two_tetrahedra(), {half_space}), (std::vector<Index>{4, 5, 6, 7})) << far;
    const Box3 slab(Vec3(-far, -far, -1), Vec3(far, far, 2));
    EXPECT_EQ(faces_near(two_tetrahedra(), {slab}), (std::vector<Index>{0, 1, 2, 3})) << far;
    std::vector<Index> all(8);
    std::iota(all.begin(), all.end(), Index{0});
    EXPECT_EQ(faces_near(two_tetrahedra(), {half_space, slab}), all) << far;
  }
}

}  // namespace
}  // namespace meshalyzer
