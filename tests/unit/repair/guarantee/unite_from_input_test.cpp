#include "meshalyzer/repair/guarantee/internal/unite_from_input.h"

#include "meshalyzer/mesh/build.h"
#include "meshalyzer/topology/components.h"
#include "support/run_pass.h"
#include "support/shapes.h"
#include "unit/repair/repaired_meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

/// A driver that has not repaired anything yet, and the result of the function.
class UniteFromInput : public ::testing::Test {
 protected:
  static constexpr double kMaxDeviation = 0.01;

  UnitedFromInput unite(const Soup& soup, const UnionChoice& choice = {}) {
    const Tolerances tolerances = resolve_tolerances({}, box_of(soup));
    driver_.emplace(soup, tolerances,
                    RepairLimits{.max_deviation = kMaxDeviation, .fixed_vertices = {}},
                    [](const TrackedMesh&, const CutMesh&) { return std::vector<std::uint8_t>(); });
    return unite_from_input(*driver_, options_, choice, memory_);
  }

  [[nodiscard]] const Soup& mesh() const { return driver_->mesh().tracked().soup; }

  RepairOptions options_;
  std::optional<RepairDriver> driver_;
  UnionMemory memory_;
};

const Soup kCrossing = shapes::merged(shapes::cube(2), shapes::cube(2, {1, 1, 1}));

TEST_F(UniteFromInput, MakesCrossingCubesOneGoodSolid) {
  EXPECT_FALSE(unite(kCrossing).note.empty());
  EXPECT_TRUE(is_good(mesh()));
  EXPECT_NEAR(volume_of(mesh()), 15, 1e-9);
  EXPECT_LT(driver_->mesh().deviation(), 1e-9);
}

TEST_F(UniteFromInput, ClosesAnOpenCubeThatCrossesAnother) {
  EXPECT_FALSE(
      unite(shapes::merged(shapes::open_cube(), shapes::cube(1, {0.5, 0.5, 0.5}))).note.empty());
  EXPECT_TRUE(is_good(mesh()));
  EXPECT_NEAR(volume_of(mesh()), 2 - 0.125, 1e-9);
}

TEST_F(UniteFromInput, MakesShellsOfPartsThatItWouldLose) {
  options_.solid = true;
  // So that nothing closes the open cube.
  options_.fill.max_edges = 3;
  const Soup soup =
      shapes::merged(shapes::cube(), shapes::translated(shapes::open_cube(), {0.5, 0.5, -0.5}));
  UnitedFromInput united = unite(soup);
  EXPECT_TRUE(united.note.empty());
  EXPECT_TRUE(united.is_too_far);
  // Its faces separate no inside from no outside, exactly; by winding number they do.
  united = unite(soup, {.shells = ShellChoice{}});
  EXPECT_TRUE(united.note.empty());
  EXPECT_TRUE(united.is_too_far);
  ASSERT_FALSE(united.lost.face_keys.empty());
  EXPECT_GE(united.lost.face_keys.front(), 12U);
  // The union without shells is remembered; made again, it has lost the same.
  ASSERT_NE(memory_.too_far, nullptr);
  memory_ = {};
  const LostBoundary lost_again = unite(soup, {.shells = ShellChoice{}}).lost;
  EXPECT_EQ(lost_again.face_keys, united.lost.face_keys);
  EXPECT_EQ(lost_again.points, united.lost.points);
  EXPECT_EQ(lost_again.has_open, united.lost.has_open);
  united =
      unite(soup, {.shells = ShellChoice{.face_keys = united.lost.face_keys, .hidden_points = {}}});
  EXPECT_NE(united.note.find("made hollow"), std::string::npos);
  EXPECT_TRUE(is_good(mesh()));
  EXPECT_LE(driver_->mesh().deviation(), kMaxDeviation);
  // Of the faces of the open cube, 4.5 lies outside the other one. At its corners, which are moved
  // along the diagonals, the shell is thinner by a factor of the root of 3 at most.
  const double thickness = 0.5 * kMaxDeviation;
  EXPECT_LT(volume_of(mesh()), 1 + 4.5 * thickness);
  EXPECT_GT(volume_of(mesh()), 1 + 4.5 * thickness / 2);
}

/// The four walls of a flat box, without top and bottom, 20 x 20 x 1.
Soup walls_of_flat_box() {
  constexpr std::array<Index, 4> kBottomAndTop{0, 1, 10, 11};
  Soup walls = shapes::without_faces(shapes::cube(), kBottomAndTop);
  for (Vec3& p : walls.positions) p = {20 * p.x() - 10, 20 * p.y() - 10, p.z()};
  return walls;
}

/// These walls with a cube in one of them, and one in the middle, which is inside once the box has
/// a top and a bottom.
Soup walls_with_cubes() {
  const Soup in_wall = shapes::cube(1, {9.5, 0.2, 0.25});
  const Soup in_middle = shapes::cube(0.5, {-0.25, -0.25, 0.25});
  return shapes::merged(walls_of_flat_box(), shapes::merged(in_wall, in_middle));
}

TEST_F(UniteFromInput, RemembersWhatOnlyLosesPartsBehindHoles) {
  options_.solid = true;
  const Soup soup = walls_with_cubes();
  EXPECT_TRUE(unite(soup).note.empty());
  ASSERT_TRUE(memory_.with_parts_dropped);
  const RejectedUnion rejected = *memory_.with_parts_dropped;
  driver_->return_to(rejected.made);
  EXPECT_TRUE(is_good(mesh()));
  // Of the cube in a wall a half is inside, but for the quarter of it that is above the box; the
  // other cube is the wall of a cavity.
  EXPECT_NEAR(volume_of(mesh()), 400 + (1 - 0.5 * 0.75) - 0.125, 1e-9);
  const Soup remembered = mesh();

  const UnitedFromInput made_again = unite(soup, {.behind_holes = BehindHoles::Dropped});
  EXPECT_FALSE(memory_.with_parts_dropped);
  EXPECT_EQ(rejected.note, made_again.note);
  EXPECT_EQ(rejected.deviation, driver_->mesh().deviation());
  EXPECT_EQ(remembered.positions, mesh().positions);
  EXPECT_EQ(remembered.triangles, mesh().triangles);
}

TEST_F(UniteFromInput, MakesShellsOfPartsWhosePatchesHideOthers) {
  options_.solid = true;
  const Soup soup = walls_with_cubes();
  UnitedFromInput united = unite(soup);
  EXPECT_TRUE(united.note.empty());
  EXPECT_TRUE(united.is_too_far);
  EXPECT_FALSE(united.lost.points.empty());
  // That cube is closed, and would be inside as a shell, too.
  united =
      unite(soup, {.shells = ShellChoice{.face_keys = united.lost.face_keys, .hidden_points = {}}});
  EXPECT_TRUE(united.note.empty());
  ASSERT_TRUE(united.is_too_far);
  EXPECT_FALSE(united.lost.has_open);
  united =
      unite(soup, {.shells = ShellChoice{.face_keys = {}, .hidden_points = united.lost.points}});
  EXPECT_NE(united.note.find("made hollow"), std::string::npos);
  EXPECT_TRUE(is_good(mesh()));
  // The cubes are solids still. At the edges, which are moved along the diagonals, the walls are
  // thinner.
  const double walls = (80.0 - 0.75) * 0.5 * kMaxDeviation;
  EXPECT_LT(volume_of(mesh()), 1.125 + walls);
  EXPECT_GT(volume_of(mesh()), 1.125 + walls / 2);
}

TEST_F(UniteFromInput, MayMovePartsOutwardFirst) {
  options_.solid = true;
  // Three cubes in a row, with walls that coincide.
  const Soup row = shapes::merged(shapes::merged(shapes::cube(), shapes::cube(1, {1, 0, 0})),
                                  shapes::cube(1, {2, 0, 0}));
  const UnitedFromInput united = unite(row, {.offset_share = 1.0 / 16.0});
  EXPECT_NE(united.note.find("each broken part was moved outward"), std::string::npos);
  EXPECT_TRUE(is_good(mesh()));
  EXPECT_EQ(find_components(build(mesh())).count, 1U);
  // Each wall has moved by a sixteenth to an eighth of the deviation, less a few thousandths.
  const double least = 0.997 * kMaxDeviation / 16;
  const double most = kMaxDeviation / 8;
  EXPECT_GE(volume_of(mesh()), (3 + 2 * least) * (1 + 2 * least) * (1 + 2 * least));
  EXPECT_LE(volume_of(mesh()), (3 + 2 * most) * (1 + 2 * most) * (1 + 2 * most));
  EXPECT_GE(driver_->mesh().deviation(), least);
  EXPECT_LE(driver_->mesh().deviation(), kMaxDeviation / 4);
}

TEST_F(UniteFromInput, LeavesAloneWhatIsGood) {
  EXPECT_TRUE(unite(shapes::cube()).note.empty());
}

TEST_F(UniteFromInput, LeavesAloneWhatHoldsASheet) {
  const Soup sheet = shapes::make({{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}});
  const Soup soup = shapes::merged(kCrossing, sheet);
  EXPECT_TRUE(unite(soup).note.empty());
  EXPECT_EQ(mesh().triangles, soup.triangles);
}

TEST_F(UniteFromInput, LeavesAloneWhatMayNotBeCut) {
  options_.fixes.erase(DefectCode::SelfIntersection);
  EXPECT_TRUE(unite(kCrossing).note.empty());
  EXPECT_EQ(mesh().triangles, kCrossing.triangles);
}

}  // namespace
}  // namespace meshalyzer
