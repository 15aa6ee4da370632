#include "meshalyzer/topology/duplicate_faces.h"

#include "direct_evaluation.h"
#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

std::vector<int> duplicates_of(const Soup& soup) {
  std::vector<int> faces;
  for (const FaceHandle f : find_duplicate_faces(build(soup))) faces.push_back(f.idx());
  return faces;
}

TEST(FindDuplicateFaces, CleanMeshHasNone) {
  EXPECT_TRUE(duplicates_of(shapes::tetrahedron()).empty());
  EXPECT_TRUE(duplicates_of(shapes::fan_of_three()).empty());
  EXPECT_TRUE(duplicates_of(Soup{}).empty());
}

TEST(FindDuplicateFaces, SameFaceTwiceIsOne) {
  const std::vector<Vec3> positions(3, Vec3::Zero());
  EXPECT_EQ(duplicates_of(shapes::make(positions, {{0, 1, 2}, {0, 1, 2}})), std::vector<int>{1});
  EXPECT_EQ(duplicates_of(shapes::make(positions, {{0, 1, 2}, {1, 2, 0}})), std::vector<int>{1});
}

TEST(FindDuplicateFaces, FaceOnTheBackOfAnotherIsOne) {
  EXPECT_EQ(duplicates_of(shapes::pillow()), std::vector<int>{1});
  EXPECT_EQ(duplicates_of(shapes::two_tetrahedra_sharing_face()), std::vector<int>{4});
}

TEST(FindDuplicateFaces, AllButTheLowestOfManyAre) {
  const Soup soup =
      shapes::make(std::vector<Vec3>(4, Vec3::Zero()),
                   {{0, 1, 3}, {0, 1, 2}, {2, 1, 0}, {1, 2, 0}, {3, 1, 0}, {0, 2, 1}});
  EXPECT_EQ(duplicates_of(soup), (std::vector<int>{2, 3, 4, 5}));
}

TEST(FindDuplicateFaces, SamePlacesUnderOtherNumbersAreNone) {
  EXPECT_TRUE(duplicates_of(shapes::merged(shapes::cube(), shapes::cube())).empty());
}

TEST(FindDuplicateFaces, AgreesWithDirectEvaluationOnRandomSoups) {
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    const Soup soup = direct::random_soup(seed, 1 + seed % 40);
    std::set<Triangle> met;
    std::vector<int> expected;
    int face = 0;
    for (Triangle t : direct::complex_of(soup).triangles) {
      std::sort(t.begin(), t.end());
      if (!met.insert(t).second) expected.push_back(face);
      ++face;
    }
    EXPECT_EQ(duplicates_of(soup), expected);
  }
}

}  // namespace
}  // namespace meshalyzer
