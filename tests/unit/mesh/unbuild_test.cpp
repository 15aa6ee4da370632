#include "meshalyzer/mesh/unbuild.h"

#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"
#include "support/soups.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace meshalyzer {
namespace {

/// The triangle begun at its smallest vertex.
Triangle from_smallest(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

TEST(Unbuild, CutMeshGivesTheFacesOfTheFile) {
  for (const Soup& soup : {shapes::cube(), shapes::fan_of_three(), shapes::moebius_strip(4),
                           shapes::two_tetrahedra_sharing_face(), shapes::klein_bottle(4, 5)}) {
    const std::vector<Triangle> triangles = unbuild(build(soup));
    ASSERT_EQ(triangles.size(), soup.n_faces());
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      EXPECT_EQ(from_smallest(triangles[f]), from_smallest(soup.triangles[f])) << "face " << f;
    }
  }
}

TEST(Unbuild, RejectedFacesAreNotInTheComplex) {
  const std::vector<Triangle> triangles = unbuild(build(soup_of(4, {{0, 1, 1}, {3, 1, 2}})));
  ASSERT_EQ(triangles.size(), 1U);
  EXPECT_EQ(from_smallest(triangles[0]), (Triangle{1, 2, 3}));
}

TEST(Unbuild, NothingGivesNothing) {
  EXPECT_TRUE(unbuild(build(Soup{})).empty());
}

}  // namespace
}  // namespace meshalyzer
