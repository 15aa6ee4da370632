#include "meshalyzer/repair/fix_defects.h"
#include "meshalyzer/repair/passes.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace meshalyzer {
namespace {

using ::testing::ElementsAre;
using ::testing::StartsWith;

PassRun drop_all(const Soup& soup) {
  return run_pass(soup, [](const PassInput& input) { return drop_copies(input); });
}

std::vector<Index> faces_from(Index first, std::size_t end) {
  std::vector<Index> faces(end - first);
  std::iota(faces.begin(), faces.end(), first);
  return faces;
}

TEST(DropCopies, OfEqualPartsTheFirstStays) {
  const Soup ball = shapes::icosphere(1);
  const Soup soup = shapes::merged(shapes::merged(ball, ball), ball);
  const PassRun run = drop_all(soup);
  EXPECT_EQ(run.operations, 2U);
  EXPECT_EQ(run.tracked.soup.n_faces(), ball.n_faces());
  for (Index face = 0; face < ball.n_faces(); ++face) {
    EXPECT_EQ(run.tracked.face_keys[face], face);
  }
}

TEST(DropCopies, DirectionDoesNotMatter) {
  const Soup sheet = shapes::grid(3, 2);
  EXPECT_EQ(drop_all(shapes::merged(sheet, shapes::flipped(sheet))).tracked.soup.n_faces(),
            sheet.n_faces());
}

TEST(DropCopies, CopyOfAPartOfASurfaceGoes) {
  const Soup ball = shapes::icosphere(2);
  const Soup patch = shapes::without_faces(ball, faces_from(30, ball.n_faces()));
  for (const Soup& soup : {shapes::merged(ball, patch), shapes::merged(patch, ball)}) {
    const PassRun run = drop_all(soup);
    EXPECT_EQ(run.tracked.soup.n_faces(), ball.n_faces());
    EXPECT_EQ(run.rounds, 1U);
  }
}

TEST(DropCopies, PartsThatCoincideOnlyPartlyStay) {
  const Soup ball = shapes::icosphere(2);
  const Soup one = shapes::without_faces(ball, faces_from(0, 20));
  const Soup other = shapes::without_faces(ball, faces_from(20, 40));
  EXPECT_EQ(drop_all(shapes::merged(one, other)).operations, 0U);
  // Two cubes with a common wall.
  EXPECT_EQ(drop_all(shapes::merged(shapes::cube(), shapes::cube(1, {1, 0, 0}))).operations, 0U);
}

TEST(DropCopies, CellAmongOthersThatTouchAllItsSidesStays) {
  Soup soup = shapes::cube();
  for (const Vec3& at : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0),
                         Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
    // Mirrored, so that the squares are cut along the same diagonals.
    Soup other = shapes::flipped(shapes::cube());
    const auto axis = at.cwiseAbs().maxCoeff() == std::abs(at.x()) ? 0 : at.y() != 0.0 ? 1 : 2;
    for (Vec3& p : other.positions) p[axis] = at[axis] > 0.0 ? 2.0 - p[axis] : -p[axis];
    soup = shapes::merged(soup, other);
  }
  EXPECT_EQ(drop_all(soup).operations, 0U);
}

TEST(DropCopies, PartsThatCoverEachOtherAreNotAllDropped) {
  // The second and the third lie on the first, and the third on the second too.
  const Soup sheet = shapes::grid(4, 1);
  const Soup half = shapes::without_faces(sheet, faces_from(4, 8));
  const Soup quarter = shapes::without_faces(sheet, faces_from(2, 8));
  const PassRun run = drop_all(shapes::merged(shapes::merged(quarter, half), sheet));
  EXPECT_EQ(run.operations, 2U);
  EXPECT_EQ(run.tracked.soup.n_faces(), sheet.n_faces());
}

TEST(DropCopies, FixedVerticesStay) {
  const Soup sheet = shapes::grid(2, 1);
  const Soup soup = shapes::merged(sheet, sheet);
  RepairLimits limits = wide_limits(soup);
  limits.fixed_vertices.assign(soup.n_vertices(), 1);
  const PassRun run = run_pass(
      soup, [](const PassInput& input) { return drop_copies(input); }, limits);
  EXPECT_EQ(run.operations, 0U);
  EXPECT_EQ(run.refused.size(), 1U);
}

TEST(DropCopies, MeshThatWasWrittenTwiceIsRepairedAsIfItWereThereOnce) {
  // Without this pass, the copies would be moved apart and joined at the hole: a shell of no
  // thickness.
  const std::vector<Index> hole{0, 1, 2, 3};
  const Soup ball = shapes::without_faces(shapes::icosphere(2), hole);
  const RepairResult once = fix_defects(ball);
  const RepairResult twice = fix_defects(shapes::merged(ball, ball));
  EXPECT_TRUE(same_soup(twice.meshes[0].tracked.soup, once.meshes[0].tracked.soup));
  EXPECT_THAT(twice.notes, ElementsAre(StartsWith("dropped, because it lies on another part: ")));
}

}  // namespace
}  // namespace meshalyzer
