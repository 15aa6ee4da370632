#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/repair/fix_defects.h"
#include "meshalyzer/repair/orient/bounds_solid.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/spatial/self_intersection.h"
#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/components.h"
#include "support/random_soups.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"
#include "unit/repair/voxel_solid.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Asks the pass until it has nothing more to propose.
PassRun cut_all(const Soup& soup) {
  return run_pass(soup, [](const PassInput& input) { return cut_intersections(input, {}); });
}

double volume(const Soup& soup) {
  double six_times = 0.0;
  for (const Triangle& t : soup.triangles) {
    six_times += soup.positions[t[0]].dot(soup.positions[t[1]].cross(soup.positions[t[2]]));
  }
  return six_times / 6.0;
}

double area(const Soup& soup) {
  double sum = 0.0;
  for (const Triangle& t : soup.triangles) {
    const Vec3& p = soup.positions[t[0]];
    sum += 0.5 * (soup.positions[t[1]] - p).cross(soup.positions[t[2]] - p).norm();
  }
  return sum;
}

bool intersects(const Soup& soup) {
  const CutMesh cut = build(soup);
  return !find_self_intersections(cut, FaceTree(cut)).empty();
}

/// Expects a mesh to come out of the default repair without any defect that was to be fixed.
Soup expect_good(const Soup& soup) {
  const RepairResult result = fix_defects(soup);
  EXPECT_EQ(result.meshes.size(), 1U);
  for (const Defect& defect : result.meshes[0].remaining.defects) {
    EXPECT_FALSE(default_fixes().contains(defect.code)) << defect_name(defect.code);
  }
  return result.meshes[0].tracked.soup;
}

TEST(CutIntersections, MeshesThatMeetNothingAreLeft) {
  for (const Soup& soup : {shapes::icosphere(2), shapes::nested_cubes(shapes::InnerShell::Cavity),
                           shapes::two_tetrahedra_sharing_vertex(), shapes::grid(3, 3)}) {
    const PassRun run = cut_all(soup);
    EXPECT_EQ(run.operations, 0U);
    EXPECT_TRUE(run.refused.empty());
  }
}

TEST(CutIntersections, SeamsThatAreOnlyNotWeldedAreLeft) {
  const Soup soup =
      shapes::merged(shapes::grid(1, 1), shapes::translated(shapes::grid(1, 1), {1, 0, 0}));
  EXPECT_EQ(cut_all(soup).operations, 0U);
}

TEST(CutIntersections, CubesThatCrossBecomeTheirUnion) {
  const Soup soup = shapes::merged(shapes::cube(2), shapes::cube(2, {1, 1, 1}));
  const PassRun run = cut_all(soup);
  EXPECT_EQ(run.operations, 1U);
  EXPECT_EQ(volume(run.tracked.soup), 15.0);
  // Two cubes of area 24, each without a corner of three unit squares.
  EXPECT_NEAR(area(run.tracked.soup), 42.0, 1e-12);
  EXPECT_FALSE(intersects(run.tracked.soup));
  EXPECT_EQ(volume(expect_good(soup)), 15.0);
}

TEST(CutIntersections, CavityThatABarCrossesStaysACavity) {
  // The bar goes through the wall of a hollow cube and 1 deep into its cavity of 2^3.
  const Soup hollow = shapes::merged(shapes::box({0, 0, 0}, {4, 4, 4}),
                                     shapes::flipped(shapes::box({1, 1, 1}, {3, 3, 3})));
  const Soup soup = shapes::merged(hollow, shapes::box({-1, 1.5, 1.5}, {2, 2.5, 2.5}));
  // 64 - 8, 1 outside and 1 in the cavity.
  EXPECT_NEAR(volume(expect_good(soup)), 58.0, 1e-12);
}

TEST(CutIntersections, CavityItselfInsideOthersIsKeptWhereItCutsItself) {
  // Two cavities that cross each other, inside one cube.
  const Soup soup =
      shapes::merged(shapes::box({0, 0, 0}, {6, 6, 6}),
                     shapes::flipped(shapes::merged(shapes::box({1, 1, 1}, {3, 3, 3}),
                                                    shapes::box({2, 2, 2}, {4, 4, 4}))));
  EXPECT_NEAR(volume(expect_good(soup)), 216.0 - 15.0, 1e-12);
}

/// A cube with a surface of unit squares.
Soup cube_of_unit_faces(int side) {
  VoxelSolid cube({side, side, side});
  for (int i = 0; i < side * side * side; ++i) {
    cube.fill({i % side, i / side % side, i / side / side});
  }
  return cube.surface();
}

TEST(CutIntersections, CubesThatOverlapAndMeetOnlyAtTheirEdgesBecomeTheirUnion) {
  const Soup cube = cube_of_unit_faces(4);
  const Soup soup = shapes::merged(cube, shapes::translated(cube, {2, 2, 2}));
  const CutMesh cut = build(soup);
  for (const IntersectingPair& pair : find_self_intersections(cut, FaceTree(cut))) {
    ASSERT_EQ(pair.kind, ContactKind::Unwelded);
  }
  const Soup united = expect_good(soup);
  EXPECT_EQ(volume(united), 64.0 + 64.0 - 8.0);
  EXPECT_EQ(area(united), 96.0 + 96.0 - 24.0);
}

TEST(CutIntersections, CubesThatShareAPartOfAWallBecomeTheirUnion) {
  const Soup cube = cube_of_unit_faces(4);
  const Soup united = expect_good(shapes::merged(cube, shapes::translated(cube, {2, 2, 0})));
  EXPECT_EQ(volume(united), 64.0 + 64.0 - 16.0);
}

TEST(CutIntersections, CubesThatTouchAreNotCut) {
  const Soup cube = cube_of_unit_faces(2);
  for (const Vec3& shift : {Vec3(2, 0, 0), Vec3(2, 2, 0), Vec3(2, 2, 2), Vec3(2, 1, 0)}) {
    const PassRun run = run_pass(shapes::merged(cube, shapes::translated(cube, shift)),
                                 [](const PassInput& input) { return part_contacts(input); });
    EXPECT_EQ(cut_all(run.tracked.soup).operations, 0U) << shift.transpose();
  }
}

/// Two squares of side 2, one upright in the middle of the other's half.
Soup upright_square_in_square() {
  Soup upright = shapes::grid(2, 2);
  for (Vec3& p : upright.positions) p = {p.x() + 0.5, 1.25, p.y() - 1.0};
  return shapes::merged(shapes::grid(2, 2), upright);
}

TEST(CutIntersections, SheetsThatCrossAreCutAndKept) {
  const Soup soup = upright_square_in_square();
  const RepairResult result = fix_defects(soup);
  const Soup& repaired = result.meshes[0].tracked.soup;
  EXPECT_FALSE(intersects(repaired));
  EXPECT_NEAR(area(repaired), area(soup), 1e-12);
  EXPECT_TRUE(result.notes.empty());
}

TEST(CutIntersections, SheetsThatCrossAlongTheirEdgesMayEndThere) {
  // The upright square goes through a row of edges, with a row of its own: no vertex is new.
  Soup upright = shapes::grid(2, 2);
  for (Vec3& p : upright.positions) p = {p.x() + 0.5, 1.0, p.y() - 1.0};
  const Soup soup = shapes::merged(shapes::grid(2, 2), upright);
  const PassRun run = run_pass(soup, [](const PassInput& input) {
    return cut_intersections(input, {.fill = {}, .sheets = Sheets::Cut});
  });
  EXPECT_EQ(run.tracked.soup.n_vertices(), soup.n_vertices());
  EXPECT_EQ(run.tracked.sheet_cuts, (std::vector<Index>{4, 5, 12, 13}));
  EXPECT_FALSE(intersects(fix_defects(soup).meshes[0].tracked.soup));
}

TEST(CutIntersections, SheetThatCrossesALargerOneIsSplitWithIt) {
  // The larger one is not kept whole for having fewer borders, with the other ending at it.
  Soup upright = shapes::grid(1, 1);
  for (Vec3& p : upright.positions) p = {p.x() * 2.0 + 2.55, 3.7, p.y() * 4.0 - 2.6};
  const Soup soup = shapes::merged(shapes::grid(8, 8), upright);
  const RepairResult result = fix_defects(soup);
  const Soup& repaired = result.meshes[0].tracked.soup;
  EXPECT_FALSE(intersects(repaired));
  EXPECT_NEAR(area(repaired), area(soup), 1e-12);
  // Both become one surface, with a border of 38 edges: where the upright square ends, the surface
  // goes round it.
  EXPECT_EQ(find_border_edges(build(repaired)).size(), 38U);
}

TEST(CutIntersections, SheetsThatLieOneOverTheOtherAreNotTakenForASolid) {
  // They cross along diagonals, and between them estimates find whole winding numbers.
  Soup low = shapes::grid(8, 8);
  Soup high = low;
  for (Vec3& p : low.positions) p.z() = 0.1 * (p.x() - 4.25);
  for (Vec3& p : high.positions) p.z() = 0.1 * (p.y() - 4.0);
  const Soup soup = shapes::merged(low, high);
  const Soup repaired = fix_defects(soup).meshes[0].tracked.soup;
  EXPECT_FALSE(intersects(repaired));
  EXPECT_NEAR(area(repaired), area(soup), 1e-9);
}

TEST(CutIntersections, LooseFacesAreLeftAndNamed) {
  const Soup soup = shapes::make(
      {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {-3, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  const PassRun run = run_pass(soup, [](const PassInput& input) {
    return cut_intersections(input, {.fill = {}, .sheets = Sheets::Cut});
  });
  EXPECT_EQ(run.operations, 0U);
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(run.refused[0].code, DefectCode::SelfIntersection);
  EXPECT_NE(run.refused[0].reason.find("loose"), std::string::npos);
}

/// Sheets in a cube of side 4, one above the other and nearly as wide, so that little of the cube
/// separates whole winding numbers by estimates, and a bar of width 1 through all.
Soup crossed_sheets(const Vec3& shift_of_sheets) {
  Soup soup = shapes::merged(shapes::cube(4), shapes::box({1, 1, -1}, {2, 2, 5}));
  for (const double z : {0.5, 1.5, 2.5, 3.5}) {
    const Soup sheet = shapes::scaled(shapes::grid(2, 2), 1.75);
    soup = shapes::merged(std::move(soup),
                          shapes::translated(sheet, Vec3(0.25, 0.25, z) + shift_of_sheets));
  }
  return soup;
}

TEST(CutIntersections, SheetsWithinTheSolidsThatTheyCrossGoWithTheirWalls) {
  // The part of the bar outside of the cube is 2 long.
  EXPECT_NEAR(volume(expect_good(crossed_sheets({0, 0, 0}))), 64.0 + 2.0, 1e-9);
}

TEST(CutIntersections, SheetsThatGoAreNamedWithTheirAreas) {
  // Each is 3.5 wide.
  const std::vector<std::string> notes = fix_defects(crossed_sheets({0, 0, 0})).notes;
  ASSERT_EQ(notes.size(), 4U);
  for (const std::string& note : notes) {
    EXPECT_NE(note.find("it lies inside a solid: an open part of area 12.25, "), std::string::npos);
  }
}

/// Returns the part of a mesh that is closed, or the part that is open.
Soup part_of(const Soup& soup, bool is_closed) {
  const CutMesh cut = build(soup);
  const Components components = find_edge_components(cut);
  const std::vector<std::uint8_t> closed = which_are_closed(cut, components);
  std::vector<Index> others;
  const std::vector<Index> of_face = components_of_file_faces(cut, components, soup.n_faces());
  for (Index face = 0; face < soup.n_faces(); ++face) {
    if ((closed[of_face[face]] != 0) != is_closed) others.push_back(face);
  }
  return shapes::without_faces(soup, others);
}

TEST(CutIntersections, SheetsStayWhereTheyLeaveTheSolidsThatTheyCross) {
  const RepairResult result = fix_defects(crossed_sheets({0.5, 0, 0}));
  const Soup& repaired = result.meshes[0].tracked.soup;
  EXPECT_FALSE(intersects(repaired));
  EXPECT_NEAR(volume(part_of(repaired, true)), 64.0 + 2.0, 1e-9);
  // A strip of each sheet, 0.25 by 3.5, is outside.
  EXPECT_NEAR(area(part_of(repaired, false)), 4 * 0.25 * 3.5, 1e-9);
  ASSERT_EQ(result.notes.size(), 4U);
  for (const std::string& note : result.notes) {
    EXPECT_NE(note.find("a solid that a sheet crosses: a part of area 11.375"), std::string::npos);
  }
  EXPECT_EQ(result.rises.size(), 1U);
}

TEST(CutIntersections, SheetsStayInCavitiesButNotInTheSolidRoundThem) {
  const Soup cavity = shapes::flipped(shapes::cube(4));
  const Soup sheet = shapes::translated(shapes::grid(2, 2), {-0.5, 1, 2});
  const Soup soup =
      shapes::merged(shapes::merged(shapes::box({-1, -1, -1}, {5, 5, 5}), cavity), sheet);
  const Soup repaired = fix_defects(soup).meshes[0].tracked.soup;
  EXPECT_FALSE(intersects(repaired));
  EXPECT_NEAR(volume(part_of(repaired, true)), 216.0 - 64.0, 1e-9);
  EXPECT_NEAR(area(part_of(repaired, false)), 1.5 * 2.0, 1e-9);
}

TEST(CutIntersections, SoManyFacesThroughOnePlaceAreNotCut) {
  // 300 faces round the origin: each of 44,850 cuts is met by up to 298 others.
  Soup soup;
  for (int i = 0; i < 300; ++i) {
    const Eigen::AngleAxisd turn(0.021 * i, Vec3(1.0, 0.3 * i, 0.07 * i * i).normalized());
    Soup face = shapes::make({{2, 0, 0}, {-1, 1.7, 0}, {-1, -1.7, 0}}, {{0, 1, 2}});
    for (Vec3& p : face.positions) p = turn * p + Vec3(0, 0, 1e-4 * i);
    soup = shapes::merged(std::move(soup), face);
  }
  const PassRun run = cut_all(soup);
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_NE(run.refused.front().reason.find("would take too long"), std::string::npos);
  EXPECT_EQ(run.tracked.soup.n_faces(), 300U);
}

/// Bars in two layers that cross each other.
Soup crossing_bars(int n) {
  Soup soup;
  for (int i = 0; i < n; ++i) {
    soup = shapes::merged(std::move(soup), shapes::box({-1, i + 0.0, 0}, {n + 1.0, i + 0.5, 1}));
    soup =
        shapes::merged(std::move(soup), shapes::box({i + 0.0, -1, 0.5}, {i + 0.5, n + 1.0, 1.5}));
  }
  return soup;
}

TEST(CutIntersections, FacesThatWouldBecomeTooManyPiecesAreNotCut) {
  const PassRun few = cut_all(crossing_bars(3));
  EXPECT_TRUE(few.refused.empty());
  EXPECT_FALSE(intersects(few.tracked.soup));
  const Soup many = crossing_bars(52);
  const PassRun run = cut_all(many);
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(run.refused.front().reason,
            "the faces would be cut into too many pieces, or at points with too many digits");
  EXPECT_EQ(run.tracked.soup.n_faces(), many.n_faces());
}

TEST(CutIntersections, CrossingPartsWithAHoleLoseOnlyWhatIsInside) {
  // The hole is in a corner that the other cube is far from.
  const std::vector<Index> hole{0};
  Soup cubes = shapes::merged(shapes::cube(4), shapes::cube(4, {3, 3, 3}));
  const double whole = 63.0 + 64.0;
  cubes = shapes::without_faces(cubes, hole);
  EXPECT_NEAR(volume(expect_good(cubes)), whole, 1e-9);
}

TEST(CutIntersections, FacesThatMeetNothingKeepTheirBits) {
  const Soup sphere = shapes::icosphere(3);
  const Soup soup = shapes::merged(sphere, shapes::translated(sphere, {1.5, 0.1, 0.2}));
  const CutMesh cut = build(soup);
  std::vector<std::uint8_t> meets(soup.n_faces(), 0);
  for (const IntersectingPair& pair : find_self_intersections(cut, FaceTree(cut))) {
    meets[pair.face_a] = 1;
    meets[pair.face_b] = 1;
  }
  const PassRun run = cut_all(soup);
  std::size_t n_kept = 0;
  for (Index f = 0; f < run.tracked.soup.n_faces(); ++f) {
    const Index key = run.tracked.face_keys[f];
    if (key >= soup.n_faces()) continue;
    ++n_kept;
    EXPECT_EQ(meets[key], 0);
    EXPECT_EQ(corners_of(run.tracked.soup, f), corners_of(soup, key));
  }
  EXPECT_GT(n_kept, soup.n_faces() / 2);
  // The volume of two balls less the lens, within what 1280 faces can tell of them.
  const double d = std::sqrt(1.5 * 1.5 + 0.1 * 0.1 + 0.2 * 0.2);
  const double lens = std::numbers::pi * (4.0 + d) * (2.0 - d) * (2.0 - d) / 12.0;
  EXPECT_NEAR(volume(run.tracked.soup), 8.0 / 3.0 * std::numbers::pi - lens, 0.1);
}

TEST(CutIntersections, BallTurnedIntoItselfSixTimesComesOutGood) {
  const Soup ball = shapes::icosphere(1);
  Soup soup = ball;
  for (int i = 1; i < 6; ++i) {
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(0.1 * i, Vec3::UnitX()) * Eigen::AngleAxisd(0.07 * i, Vec3::UnitZ()))
            .toRotationMatrix();
    Soup turned = ball;
    for (Vec3& p : turned.positions) p = turn * p;
    soup = shapes::merged(std::move(soup), turned);
  }
  const Soup united = cut_all(soup).tracked.soup;
  EXPECT_FALSE(intersects(united));
  EXPECT_GT(volume(united), volume(ball));
  EXPECT_LT(volume(united), 4.0 / 3.0 * std::numbers::pi);
}

/// Boxes with corners on a lattice, turned together, so that faces which are to coincide are some
/// roundings apart.
struct TurnedBoxes {
  Soup soup;
  /// The volume of their union.
  double volume = 0.0;
};

TurnedBoxes turned_boxes(std::size_t n, std::mt19937& random) {
  Soup soup;
  VoxelSolid cells({6, 6, 6});
  for (std::size_t i = 0; i < n; ++i) {
    std::array<int, 3> low{};
    std::array<int, 3> high{};
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = static_cast<int>(below(random, 4));
      high[k] = low[k] + 1 + static_cast<int>(below(random, 3));
    }
    for (int x = low[0]; x < high[0]; ++x) {
      for (int y = low[1]; y < high[1]; ++y) {
        for (int z = low[2]; z < high[2]; ++z) cells.fill({x, y, z});
      }
    }
    soup = shapes::merged(std::move(soup), shapes::box(Vec3(low[0], low[1], low[2]),
                                                       Vec3(high[0], high[1], high[2])));
  }
  const auto angle = [&] { return uniform(random, 0.0, 2.0 * std::numbers::pi); };
  const Eigen::Matrix3d turned =
      (Eigen::AngleAxisd(angle(), Vec3::UnitX()) * Eigen::AngleAxisd(angle(), Vec3::UnitY()) *
       Eigen::AngleAxisd(angle(), Vec3::UnitZ()))
          .toRotationMatrix();
  for (Vec3& p : soup.positions) {
    p = turned * p;
    for (double& x : p) x += uniform(random, -1e-15, 1e-15);
  }
  return {std::move(soup), static_cast<double>(cells.full_cells().size())};
}

TEST(CutIntersections, BoxesWhoseCommonFacesAreRoundingsApartBecomeTheirUnion) {
  std::mt19937 random(7);
  const Soup ball = shapes::translated(shapes::icosphere(1), {20.0, 0.1, 0.2});
  for (int i = 0; i < 30; ++i) {
    const TurnedBoxes boxes = turned_boxes(6, random);
    const PassRun run = cut_all(shapes::merged(ball, boxes.soup));
    const Soup& cut = run.tracked.soup;
    EXPECT_TRUE(run.refused.empty());
    EXPECT_FALSE(intersects(cut));
    EXPECT_NEAR(volume(cut), boxes.volume + volume(ball), 1e-3);
    // What intersects nothing keeps its bits, even if other vertices move to a grid.
    EXPECT_TRUE(std::equal(ball.positions.begin(), ball.positions.end(), cut.positions.begin()));
  }
}

TEST(CutIntersections, NumberOfThreadsDoesNotMatter) {
  const Soup sphere = shapes::icosphere(3);
  const Soup soup = shapes::merged(sphere, shapes::translated(sphere, {0.5, 0.1, 0.2}));
  const auto with = [&](std::size_t n) {
    const ThreadLimit limit(n);
    return cut_all(soup).tracked.soup;
  };
  EXPECT_TRUE(same_soup(with(1), with(2)));
}

TEST(CutIntersections, SecondRepairChangesNothing) {
  const Soup once = expect_good(shapes::merged(
      shapes::icosphere(2), shapes::translated(shapes::icosphere(2), {0.7, 0.2, 0.1})));
  const RepairResult again = fix_defects(once);
  EXPECT_TRUE(again.log.steps.empty());
  EXPECT_TRUE(same_soup(again.meshes[0].tracked.soup, once));
}

}  // namespace
}  // namespace meshalyzer
