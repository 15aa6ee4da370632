#include "meshalyzer/repair/guarantee/internal/guarantee.h"

#include "support/run_pass.h"
#include "support/shapes.h"
#include "unit/repair/repaired_meshes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

RepairOptions to_solid() {
  RepairOptions options;
  options.solid = true;
  options.guarantee = true;
  options.fill.sheets = FillSheets::Yes;
  return options;
}

/// What is good in the end, of one mesh, and within the maximum deviation.
Soup made_good(const Soup& soup, const RepairOptions& options) {
  const RepairResult result = fix_defects(soup, options);
  EXPECT_TRUE(is_good(only_mesh(result)));
  EXPECT_LE(result.deviation, result.max_deviation);
  return only_mesh(result);
}

const Soup kFace = shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});

TEST(Guarantee, CubesThatCrossAreReplacedByTheirUnion) {
  RepairOptions options = to_solid();
  // So that nothing but the replacement can help. Volumes 8 + 8 - 1.
  options.fixes.erase(DefectCode::SelfIntersection);
  options.max_deviation.value = 0.01;
  const Soup cubes = shapes::merged(shapes::cube(2), shapes::cube(2, {1, 1, 1}));
  const RepairResult result = fix_defects(cubes, options);
  EXPECT_TRUE(is_good(only_mesh(result)));
  EXPECT_TRUE(is_noted(result, "was replaced by a new surface"));
  EXPECT_LE(result.deviation, result.max_deviation);
  EXPECT_NEAR(volume_of(only_mesh(result)), 15, 0.3);
}

TEST(Guarantee, UnionThatLosesPartsIsMadeAgainBeforeTheyAreReplaced) {
  RepairOptions options = to_solid();
  options.max_deviation.value = 0.01;
  // So that nothing closes the open cube.
  options.fill.max_edges = 3;
  const Soup soup =
      shapes::merged(shapes::cube(), shapes::translated(shapes::open_cube(), {0.5, 0.5, -0.5}));
  const RepairResult result = fix_defects(soup, options);
  EXPECT_TRUE(is_good(only_mesh(result)));
  EXPECT_TRUE(is_noted(result, "made hollow"));
  EXPECT_FALSE(is_noted(result, "was replaced by a new surface"));
  // A new surface would have thousands of faces.
  EXPECT_LT(only_mesh(result).n_faces(), 200U);
}

TEST(Guarantee, InputIsReplacedWhereRepairsHaveUsedUpTheDeviation) {
  constexpr double kMaxDeviation = 0.03;
  RepairOptions options = to_solid();
  // So that nothing but the replacement can help.
  options.fixes.erase(DefectCode::SelfIntersection);
  const Soup cubes = shapes::merged(shapes::cube(2), shapes::cube(2, {1, 1, 1}));
  const Tolerances tolerances = resolve_tolerances({}, box_of(cubes));
  RepairDriver driver(
      cubes, tolerances, RepairLimits{.max_deviation = kMaxDeviation, .fixed_vertices = {}},
      [](const TrackedMesh&, const CutMesh&) { return std::vector<std::uint8_t>(); });
  driver.mesh().raise_deviation(kMaxDeviation);
  EXPECT_EQ(guarantee_goodness(driver, options).size(), 1U);
  EXPECT_TRUE(is_good(driver.mesh().tracked().soup));
  EXPECT_NEAR(volume_of(driver.mesh().tracked().soup), 15, 0.5);
  EXPECT_LE(driver.mesh().deviation(), kMaxDeviation);
}

TEST(Guarantee, CubesThatTouchAndCannotBePartedAreJoined) {
  // They could be parted, if the passes had run before.
  const Soup cubes = shapes::merged(shapes::cube(), shapes::cube(1, {1, 1, 1}));
  RepairOptions options = to_solid();
  // So that the mesh is not united with itself.
  options.fixes.erase(DefectCode::SelfIntersection);
  const Tolerances tolerances = resolve_tolerances({}, box_of(cubes));
  constexpr double kMaxDeviation = 0.01;
  RepairDriver driver(
      cubes, tolerances, RepairLimits{.max_deviation = kMaxDeviation, .fixed_vertices = {}},
      [](const TrackedMesh&, const CutMesh&) { return std::vector<std::uint8_t>(); });
  EXPECT_EQ(guarantee_goodness(driver, options),
            std::vector<std::string>{"what touched, and could not be parted, was joined there"});
  EXPECT_TRUE(is_good(driver.mesh().tracked().soup));
  // Twice the volume of a cube, and a rod a sixteenth of the deviation thick.
  EXPECT_NEAR(volume_of(driver.mesh().tracked().soup), 2, kMaxDeviation * kMaxDeviation);
  EXPECT_LE(driver.mesh().deviation(), kMaxDeviation);
}

TEST(Guarantee, WhatIsGoodStaysAsItIs) {
  const RepairResult result = fix_defects(shapes::cube(), to_solid());
  EXPECT_TRUE(result.log.steps.empty());
  EXPECT_TRUE(result.notes.empty());
}

TEST(Guarantee, LoneFaceBesideABlockIsDroppedAndNamedWithItsArea) {
  const Soup soup = shapes::merged(shapes::cube(), shapes::translated(kFace, {3, 0, 0}));
  const RepairResult result = fix_defects(soup, to_solid());
  EXPECT_EQ(only_mesh(result).n_faces(), 12U);
  EXPECT_TRUE(is_good(only_mesh(result)));
  EXPECT_TRUE(is_noted(result, "a fragment of area 0.5"));
}

TEST(Guarantee, OneFaceBecomesAThinSolid) {
  EXPECT_EQ(made_good(kFace, to_solid()).n_faces(), 8U);
  EXPECT_TRUE(is_noted(fix_defects(kFace, to_solid()), "was made a solid"));
}

TEST(Guarantee, FaceOfAnySizeBecomesAThinSolid) {
  for (const double size : {1e-200, 1e-100, 1e100, 1e200, 1e300}) {
    SCOPED_TRACE(size);
    Soup face = kFace;
    for (Vec3& p : face.positions) p *= size;
    EXPECT_EQ(made_good(face, to_solid()).n_faces(), 8U);
  }
}

TEST(Guarantee, FaceWhoseSolidWouldNotFitIntoDoublesStaysAsItIs) {
  const double most = std::numeric_limits<double>::max();
  const Soup face = shapes::make({{most, 0, 0}, {most, 1e308, 0}, {most, 0, 1e308}}, {{0, 1, 2}});
  const RepairResult result = fix_defects(face, to_solid());
  EXPECT_EQ(only_mesh(result).positions, face.positions);
  EXPECT_TRUE(is_noted(result, "not replaced"));
}

TEST(Guarantee, PlateBecomesAThinSolid) {
  static_cast<void>(made_good(shapes::grid(5, 4), to_solid()));
}

TEST(Guarantee, MoebiusStripBecomesAThinSolid) {
  static_cast<void>(made_good(shapes::moebius_strip(24), to_solid()));
}

TEST(Guarantee, ClosedSurfaceInAPlaneBecomesAThinSolid) {
  // A face and its back; a parallelogram, divided another way on its back.
  const Soup pillow = shapes::make(kFace.positions, {{0, 1, 2}, {0, 2, 1}});
  const Soup parallelogram = shapes::make({{0, 0, 0}, {1, 0, 1}, {1, 1, 2}, {0, 1, 1}},
                                          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
  // Two sides of one half, and a rim round it.
  EXPECT_EQ(made_good(pillow, to_solid()).n_faces(), 2U * 1 + 6);
  EXPECT_EQ(made_good(parallelogram, to_solid()).n_faces(), 2U * 2 + 8);
}

TEST(Guarantee, SheetsWhoseThinSolidIntersectsItselfStayWithThatReason) {
  RepairOptions options = to_solid();
  // So that what intersects is not cut.
  options.fixes.erase(DefectCode::SelfIntersection);
  const Soup faces = shapes::merged(
      kFace, shapes::make({{0.2, 0.2, -1}, {0.3, 0.2, 1}, {0.2, 0.9, 0.1}}, {{0, 1, 2}}));
  const RepairResult result = fix_defects(faces, options);
  EXPECT_EQ(only_mesh(result).triangles, faces.triangles);
  EXPECT_TRUE(is_noted(result, "as a thin solid it would still intersect itself, in "));
}

TEST(Guarantee, SheetStaysOneUnlessASolidIsAskedFor) {
  RepairOptions options;
  options.guarantee = true;
  const Soup grid = shapes::grid(3, 3);
  const RepairResult result = fix_defects(grid, options);
  EXPECT_EQ(only_mesh(result).triangles, grid.triangles);
  EXPECT_TRUE(is_noted(result, "it is a sheet"));
}

/// What is left as it is, except for repairs that keep the borders, with a reason.
void expect_not_replaced(const Soup& soup, RepairOptions options) {
  options.guarantee = true;
  // So that nothing but a replacement could help.
  options.fixes.erase(DefectCode::SelfIntersection);
  options.max_deviation.value = 0.05;
  const RepairResult result = fix_defects(soup, options);
  EXPECT_TRUE(is_noted(result, "borders that are to be kept"));
  EXPECT_EQ(only_mesh(result).positions, soup.positions);
  EXPECT_EQ(only_mesh(result).triangles, soup.triangles);
}

TEST(Guarantee, IntendedBordersStay) {
  RepairOptions options;
  options.borders = Borders::Intended;
  expect_not_replaced(shapes::merged(shapes::open_cube(), shapes::cube(1, {0.5, 0.5, -0.5})),
                      options);
}

TEST(Guarantee, CommonBordersOfTheFacesOfABodyStay) {
  RepairOptions options;
  options.groups = Groups::Faces;
  Soup soup = shapes::merged(shapes::cube(2), shapes::cube(2, {1, 1, 1}));
  soup.groups = {{"a", 0}, {"b", 4}};
  expect_not_replaced(soup, options);
  // Where each cube is a group, there are none.
  soup.groups = {{"a", 0}, {"b", 12}};
  options.guarantee = true;
  options.fixes.erase(DefectCode::SelfIntersection);
  options.max_deviation.value = 0.05;
  made_good(soup, options);
}

TEST(Guarantee, PointsAloneAreRefused) {
  const RepairResult result = fix_defects(shapes::make({{0, 0, 0}, {1, 0, 0}}, {}), to_solid());
  EXPECT_TRUE(is_noted(result, "there is no face"));
}

TEST(Guarantee, WithoutDeviationNothingIsReplaced) {
  RepairOptions options = to_solid();
  options.max_deviation.value = 0.0;
  EXPECT_TRUE(is_noted(fix_defects(kFace, options), "not replaced"));
}

TEST(Guarantee, DamagedMeshesEndGoodOrWithAReason) {
  std::mt19937 random(16);
  const auto below = [&](std::size_t n) { return static_cast<Index>(random() % n); };
  RepairOptions options = to_solid();
  options.max_deviation.value = 0.01;
  for (int trial = 0; trial < 12; ++trial) {
    Soup soup = shapes::icosphere(1);
    for (int i = 0; i < 3; ++i) {
      Triangle& t = soup.triangles[below(soup.n_faces())];
      std::swap(t[1], t[2]);
    }
    for (int i = 0; i < 2; ++i) soup.positions[below(soup.n_vertices())] *= 0.7;
    soup = shapes::without_faces(soup, std::vector<Index>{below(20), 20 + below(20)});
    const RepairResult result = fix_defects(soup, options);
    const bool has_reason = is_noted(result, "not ");
    EXPECT_NE(is_good(only_mesh(result)), has_reason) << trial;
  }
}

}  // namespace
}  // namespace meshalyzer
