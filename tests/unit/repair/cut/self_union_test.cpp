#include "meshalyzer/repair/passes.h"
#include "support/run_pass.h"
#include "support/shapes.h"
#include "unit/repair/repaired_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace meshalyzer {
namespace {

/// A box without the two faces across an axis.
Soup open_box(const Vec3& low, const Vec3& high, int axis) {
  Soup soup = shapes::box(low, high);
  std::erase_if(soup.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](Index v) {
      return soup.positions[v][axis] == soup.positions[t[0]][axis];
    });
  });
  return soup;
}

PassRun unite(const Soup& soup, LostParts lost) {
  return run_pass(
      soup, [&](const PassInput& input) { return self_union(input, {.fill = {}, .lost = lost}); });
}

// The first tube ends in a wall of the second, so that any patch for this end crosses it. Its
// volume is 22, that of the second 140, and 10.5 is common to both.
TEST(SelfUnion, OpenTubesThatCrossAreClosedAndOne) {
  const Soup tubes = shapes::merged(open_box({-4, -1, -1}, {1.5, 1, 1}, 0),
                                    open_box({-2, -0.5, -5}, {2, 3, 5}, 2));
  const PassRun run = unite(tubes, LostParts::Refused);
  EXPECT_TRUE(is_good(run.tracked.soup));
  EXPECT_NEAR(volume_of(run.tracked.soup), 22 + 140 - 10.5, 1e-9);
  EXPECT_EQ(run.operations, 1U);
}

TEST(SelfUnion, KeepsWhatTheOppositeOrientationSurrounds) {
  // The corner of one cube in the other has winding number 1 - 1, the rest of them 1 and -1.
  const Soup cubes = shapes::merged(shapes::cube(2), shapes::flipped(shapes::cube(2, {1, 1, 1})));
  const PassRun run = unite(cubes, LostParts::Refused);
  EXPECT_NEAR(volume_of(run.tracked.soup), 8 + 8 - 2 * 1, 1e-9);
}

TEST(SelfUnion, OpenPartIsLostOnlyIfThatIsAllowed) {
  // The tube lies in the block and in the bar that stands out of it; its end in the bar is crossed
  // by a wall of the bar.
  const Soup solids = shapes::merged(shapes::cube(10), shapes::box({5, 4, 4}, {15, 6, 6}));
  const Soup soup = shapes::merged(solids, open_box({6, 2, 3.5}, {7, 5, 5.5}, 1));
  const PassRun refused = unite(soup, LostParts::Refused);
  EXPECT_EQ(refused.operations, 0U);
  ASSERT_FALSE(refused.refused.empty());
  EXPECT_NE(refused.refused.front().reason.find("cavity"), std::string::npos);
  const PassRun allowed = unite(soup, LostParts::Allowed);
  EXPECT_TRUE(is_good(allowed.tracked.soup));
  EXPECT_NEAR(volume_of(allowed.tracked.soup), 1000 + 5 * 4, 1e-9);
}

TEST(SelfUnion, GoodMeshStaysAsItIs) {
  EXPECT_EQ(unite(shapes::cube(), LostParts::Allowed).operations, 0U);
}

}  // namespace
}  // namespace meshalyzer
