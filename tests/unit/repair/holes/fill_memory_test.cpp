#include "meshalyzer/repair/internal/pass_memory.h"
#include "support/run_pass.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <utility>

namespace meshalyzer {
namespace {

/// A needle through the opening of the open cube: every patch meets it.
Soup open_cube_with_obstacle(double height = 3) {
  const Soup needle =
      shapes::make({{0.3, 0.3, 0.5}, {0.7, 0.3, 0.5}, {0.5, 0.8, 0.5}, {0.5, 0.5, height}},
                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  return shapes::merged(shapes::open_cube(), needle);
}

/// Notes that the only loop of a mesh has no patch, and recalls it for another mesh.
class FillMemoryTest : public ::testing::Test {
 protected:
  explicit FillMemoryTest(const Soup& soup = open_cube_with_obstacle()) { note(soup); }

  [[nodiscard]] std::optional<Filling> recall(TrackedMesh tracked) {
    const Given given(std::move(tracked));
    FillMemory memory(failed_, given.input);
    return memory.recall(given.loops.loops.at(0));
  }

  [[nodiscard]] std::optional<Filling> recall(const Soup& soup) { return recall(track_mesh(soup)); }

  Filling noted_{.patch = std::nullopt,
                 .reason = "it is too small",
                 .first = Patch{.triangles = {{}}, .added = {}}};

 private:
  /// A mesh and its loops.
  struct Given {
    explicit Given(TrackedMesh mesh)
        : tracked(std::move(mesh)),
          prepared(tracked.soup),
          tolerances(resolve_tolerances({}, box_of(tracked.soup))),
          limits(wide_limits(tracked.soup)),
          input{tracked.soup, tracked, prepared, tolerances, limits},
          loops(find_hole_loops(prepared)) {}

    TrackedMesh tracked;
    PreparedMesh prepared;
    Tolerances tolerances;
    RepairLimits limits;
    PassInput input;
    HoleLoops loops;
  };

  void note(const Soup& soup) {
    const Given given(track_mesh(soup));
    const HoleLoop& loop = given.loops.loops.at(0);
    noted_.first->triangles = {{loop.vertices[0], loop.vertices[1], loop.vertices[2]}};
    Box3 region;
    for (const Index v : loop.vertices) region.extend(soup.positions[v]);
    FillMemory(failed_, given.input).note(loop, region, noted_);
  }

  FailedFillings failed_;
};

TEST_F(FillMemoryTest, RecallsWhatWasNoted) {
  const std::optional<Filling> known = recall(open_cube_with_obstacle());
  ASSERT_TRUE(known);
  EXPECT_FALSE(known->patch);
  EXPECT_EQ(known->reason, noted_.reason);
  ASSERT_TRUE(known->first);
  EXPECT_EQ(known->first->triangles, noted_.first->triangles);
}

TEST_F(FillMemoryTest, DoesNotDependOnTheNumbersOfVertices) {
  TrackedMesh tracked = track_mesh(open_cube_with_obstacle());
  // A vertex that nothing uses, at the front.
  Soup& soup = tracked.soup;
  soup.positions.insert(soup.positions.begin(), Vec3(9, 9, 9));
  tracked.vertex_keys.insert(tracked.vertex_keys.begin(), 99);
  for (Triangle& t : soup.triangles) {
    for (Index& v : t) ++v;
  }
  const std::optional<Filling> known = recall(tracked);
  ASSERT_TRUE(known);
  Triangle expected = noted_.first->triangles[0];
  for (Index& v : expected) ++v;
  EXPECT_EQ(known->first->triangles[0], expected);
}

TEST_F(FillMemoryTest, ForgetsWhereAnythingRoundTheLoopHasChanged) {
  EXPECT_FALSE(recall(shapes::open_cube()));
  EXPECT_FALSE(recall(open_cube_with_obstacle(2.9)));
  const Soup far = shapes::translated(shapes::tetrahedron(), {20, 0, 0});
  EXPECT_TRUE(recall(shapes::merged(open_cube_with_obstacle(), far)));
  const Soup near = shapes::translated(shapes::tetrahedron(), {0.9, 0.9, 0.9});
  EXPECT_FALSE(recall(shapes::merged(open_cube_with_obstacle(), near)));
}

TEST(HoleFilling, TriesALoopAgainOnceItsObstacleIsGone) {
  PassMemory memory;
  const PassFunction fill = remembering(memory, hole_filling({.sheets = FillSheets::Yes}));
  const PassRun in_vain = run_pass(open_cube_with_obstacle(), fill);
  EXPECT_EQ(in_vain.operations, 0U);
  ASSERT_EQ(in_vain.refused.size(), 1U);
  const PassRun again = run_pass(open_cube_with_obstacle(), fill);
  ASSERT_EQ(again.refused.size(), 1U);
  EXPECT_EQ(again.refused[0].reason, in_vain.refused[0].reason);
  EXPECT_EQ(memory.holes.failed.attempts.size(), 1U);
  EXPECT_EQ(run_pass(shapes::open_cube(), fill).operations, 1U);
}

}  // namespace
}  // namespace meshalyzer
