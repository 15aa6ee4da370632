#include "meshalyzer/repair/records/internal/keep_largest.h"

#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

PassFunction keeping(std::size_t n) {
  return [n](const PassInput& input) { return keep_largest(input, n); };
}

/// 4, 12 and 320 faces.
Soup small_middle_large() {
  return shapes::merged(shapes::merged(shapes::tetrahedron(), shapes::cube(1.0, Vec3(5, 0, 0))),
                        shapes::translated(shapes::icosphere(2), Vec3(20, 0, 0)));
}

TEST(KeepLargest, SmallerComponentsGoWithTheirVertices) {
  const PassRun run = run_pass(small_middle_large(), keeping(1));
  EXPECT_TRUE(same_bits(run.tracked.soup.positions,
                        shapes::translated(shapes::icosphere(2), Vec3(20, 0, 0)).positions));
  EXPECT_EQ(run.tracked.soup.n_faces(), 320U);
  EXPECT_EQ(run.tracked.face_keys.front(), 16U);
}

TEST(KeepLargest, SeveralStayInTheirOrder) {
  const PassRun run = run_pass(small_middle_large(), keeping(2));
  EXPECT_EQ(run.tracked.soup.n_faces(), 332U);
  EXPECT_EQ(run.tracked.face_keys.front(), 4U);
}

TEST(KeepLargest, OfEqualOnesTheFirstStays) {
  const Soup soup = shapes::merged(shapes::cube(), shapes::cube(1.0, Vec3(5, 0, 0)));
  EXPECT_EQ(run_pass(soup, keeping(1)).tracked.face_keys.front(), 0U);
}

TEST(KeepLargest, AsManyAsThereAreChangeNothing) {
  EXPECT_EQ(run_pass(small_middle_large(), keeping(3)).operations, 0U);
  EXPECT_EQ(run_pass(Soup{}, keeping(1)).operations, 0U);
}

}  // namespace
}  // namespace meshalyzer
