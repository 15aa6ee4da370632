#include "meshalyzer/repair/fix_defects.h"

#include "meshalyzer/base/error.h"
#include "support/constants.h"
#include "support/foldovers.h"
#include "support/no_lengths.h"
#include "support/same_soup.h"
#include "support/shapes.h"
#include "unit/repair/cell_complex.h"
#include "unit/repair/overlapping_boxes.h"
#include "unit/repair/repaired_meshes.h"
#include "unit/repair/weld/weld_cases.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

namespace meshalyzer {
namespace {

using enum DefectCode;

TEST(FixDefects, GoodMeshesComeOutBitForBitAndNothingIsLogged) {
  for (const Soup& soup :
       {shapes::tetrahedron(), shapes::cube(1e-300), shapes::icosphere(2), shapes::genus_block(3),
        shapes::torus(3, 1, 9, 7), shapes::nested_cubes(shapes::InnerShell::Cavity),
        cube_with_groups(), cube_with_normals()}) {
    const RepairResult result = fix_defects(soup);
    EXPECT_TRUE(same_soup(only_mesh(result), soup));
    EXPECT_TRUE(result.log.steps.empty());
    EXPECT_TRUE(result.log.operations.empty());
    EXPECT_TRUE(result.log.refusals.empty());
    EXPECT_EQ(result.deviation, 0.0);
  }
}

TEST(FixDefects, EmptyMeshComesOutEmpty) {
  const RepairResult result = fix_defects({});
  EXPECT_EQ(only_mesh(result).n_faces(), 0U);
  EXPECT_EQ(only_mesh(result).n_vertices(), 0U);
  EXPECT_TRUE(result.log.operations.empty());
  EXPECT_EQ(result.max_deviation, 0.0);
}

TEST(FixDefects, MeshOfVerticesAloneKeepsThem) {
  const Soup soup = shapes::make({{0, 0, 0}, {1, 2, 3}}, {});
  const RepairResult result = fix_defects(soup);
  EXPECT_TRUE(same_soup(only_mesh(result), soup));
  EXPECT_TRUE(is_refused(result, OrphanVertex, ""));
}

TEST(FixDefects, SolidsThatOverlapWithACommonSideBecomeOne) {
  EXPECT_NEAR(volume_of(only_mesh(fix_defects(boxes_with_a_common_side()))), 3.0, 1e-12);
}

TEST(FixDefects, HoleFromOneSideToAnotherStaysOne) {
  EXPECT_NEAR(volume_of(only_mesh(fix_defects(cube_and_hole()))), 24.0, 1e-12);
  EXPECT_NEAR(volume_of(only_mesh(fix_defects(shapes::flipped(cube_and_hole())))), 24.0, 1e-12);
}

TEST(FixDefects, CellsThatShareTheirWallsBecomeASolidEach) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const CellComplex complex = random_complex({2, 3, 3}, 3, random);
    const Soup soup = complex.faces().soup;
    const Soup repaired = only_mesh(fix_defects(i % 2 == 0 ? soup : shapes::flipped(soup)));
    EXPECT_TRUE(is_good(repaired)) << i;
    EXPECT_EQ(PreparedMesh(repaired).shells().size(), complex.n_parts()) << i;
    EXPECT_NEAR(volume_of(repaired), complex.volume(), 1e-9) << i;
  }
}

TEST(FixDefects, EachOfAThousandCellsBecomesASolid) {
  std::mt19937 random(1);
  const CellComplex complex = random_complex({10, 10, 10}, 1000000, random);
  const Soup repaired = only_mesh(fix_defects(complex.faces().soup));
  EXPECT_TRUE(is_good(repaired));
  EXPECT_EQ(PreparedMesh(repaired).shells().size(), complex.n_parts());
}

TEST(FixDefects, WallsStayWhereFacesMayTouchAndWhereNothingMayMove) {
  CellComplex complex({2, 1, 1});
  complex.assign({0, 0, 0}, 1);
  complex.assign({1, 0, 0}, 2);
  const Soup soup = complex.faces().soup;
  RepairOptions options;
  options.contact = Contact::Keep;
  EXPECT_TRUE(same_soup(only_mesh(fix_defects(soup, options)), soup));
  options.contact = Contact::Part;
  options.max_deviation = {0.0, Deviation::Unit::Length};
  EXPECT_TRUE(same_soup(only_mesh(fix_defects(soup, options)), soup));
}

TEST(FixDefects, CellsThatShareTheirWallsAreOneSolidWhereASolidIsMeant) {
  RepairOptions options;
  options.solid = true;
  std::mt19937 random(2);
  for (int i = 0; i < 20; ++i) {
    const CellComplex complex = random_complex({2, 3, 3}, 3, random);
    const RepairResult result = fix_defects(complex.faces().soup, options);
    EXPECT_TRUE(is_good(only_mesh(result))) << i;
    EXPECT_EQ(PreparedMesh(only_mesh(result)).shells().size(), 1U) << i;
    EXPECT_EQ(volume_of(only_mesh(result)), complex.volume()) << i;
    EXPECT_TRUE(is_noted(result, "dropped, because it divides a solid: a wall of area ")) << i;
    EXPECT_EQ(result.deviation, 0.0) << i;
  }
}

TEST(FixDefects, PositionThatIsNotFiniteIsRefused) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Soup soup = shapes::cube();
    soup.positions[3].y() = bad;
    EXPECT_THROW(static_cast<void>(fix_defects(soup)), InvalidArgument);
  }
}

TEST(FixDefects, DeviationThatIsNoLengthIsRefused) {
  for (const auto unit : {Deviation::Unit::Length, Deviation::Unit::Diagonal}) {
    for (const double bad : {-1e-300, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
      RepairOptions options;
      options.max_deviation = {bad, unit};
      EXPECT_THROW(static_cast<void>(fix_defects(shapes::cube(), options)), InvalidArgument);
    }
  }
}

TEST(FixDefects, DeviationIsALengthOrAShareOfTheDiagonal) {
  RepairOptions options;
  options.max_deviation = {0.25, Deviation::Unit::Length};
  EXPECT_EQ(fix_defects(shapes::cube(), options).max_deviation, 0.25);
  options.max_deviation = {0.25, Deviation::Unit::Diagonal};
  EXPECT_DOUBLE_EQ(fix_defects(shapes::cube(), options).max_deviation, 0.25 * std::sqrt(3.0));
}

TEST(FixDefects, DeviationIsAShareOfDiagonalsWhoseSquaresAreNoDoubles) {
  // The square root of 3 times the side, a thousandth of it.
  for (const double side : {1e-200, 1e306}) {
    EXPECT_NEAR(fix_defects(shapes::cube(side)).max_deviation / side, 0.001 * std::sqrt(3.0),
                1e-15);
  }
}

TEST(FixDefects, FaceWithAMissingVertexGoes) {
  Soup soup = shapes::cube();
  soup.triangles.push_back({0, 1, kNoIndex});
  soup.missing.push_back({12, 2, 99});
  const RepairResult result = expect_mended(soup, Corrupt);
  EXPECT_TRUE(same_soup(only_mesh(result), shapes::cube()));
}

TEST(FixDefects, FaceGivenTwiceStaysOnce) {
  Soup soup = shapes::cube();
  soup.triangles.push_back(soup.triangles[5]);
  EXPECT_TRUE(same_soup(only_mesh(expect_mended(soup, DuplicateFacet)), shapes::cube()));
}

TEST(FixDefects, FaceThatRepeatsAVertexGoes) {
  Soup soup = shapes::cube();
  soup.triangles.push_back({4, 4, 5});
  EXPECT_TRUE(same_soup(only_mesh(expect_mended(soup, DegenerateFacet)), shapes::cube()));
}

TEST(FixDefects, NeedlesAreCollapsed) {
  const RepairResult result = expect_mended(with_needles(), DegenerateFacet);
  // Euler: a collapse takes away one vertex and two faces.
  EXPECT_EQ(only_mesh(result).n_vertices(), 12U);
  EXPECT_EQ(only_mesh(result).n_faces(), 20U);
  EXPECT_LE(result.deviation, 1e-11);
}

TEST(FixDefects, CapsAreBentAwayAndFacesNearlyFlatAreNot) {
  // The edges are about 1 long, so the height is that of the cap; the tolerance 1e-8 of the
  // diagonal, which is less than 4.
  EXPECT_EQ(count_after(expect_mended(with_cap(1e-10), FlatFacet), FlatFacet), 0U);
  const Soup near_cap = with_cap(1e-6);
  const RepairResult near = fix_defects(near_cap);
  EXPECT_EQ(near.before.total(), 0U);
  EXPECT_TRUE(same_soup(only_mesh(near), near_cap));
}

TEST(FixDefects, UnweldedFacesAreJoined) {
  const RepairResult result = expect_mended(unwelded(shapes::icosphere(1)), Slit);
  EXPECT_EQ(only_mesh(result).n_vertices(), 42U);
  EXPECT_EQ(result.deviation, 0.0);
}

TEST(FixDefects, SolidsThatShareAVertexOrAnEdgeComeApart) {
  for (const Soup& soup :
       {shapes::two_tetrahedra_sharing_vertex(), shapes::two_tetrahedra_sharing_edge()}) {
    RepairOptions options;
    options.fixes.insert(Disjoint);
    const RepairResult result = fix_defects(soup, options);
    EXPECT_GT(result.before.count(NonManifold), 0U);
    ASSERT_EQ(result.meshes.size(), 2U);
    for (const RepairedMesh& mesh : result.meshes) {
      EXPECT_EQ(mesh.remaining.total(), mesh.remaining.count(Numbering));
      EXPECT_EQ(mesh.tracked.soup.n_faces(), 4U);
      EXPECT_NEAR(volume_of(mesh.tracked.soup), 1.0 / 6, 1e-9);
    }
  }
}

TEST(FixDefects, SolidsThatComeApartAreNumberedFromOneOn) {
  RepairOptions options;
  options.fixes = DefectCodes::all();
  const RepairResult result = fix_defects(shapes::two_tetrahedra_sharing_vertex(), options);
  ASSERT_EQ(result.meshes.size(), 2U);
  for (const RepairedMesh& mesh : result.meshes) {
    EXPECT_EQ(mesh.remaining.total(), 0U);
    for (Index v = 0; v < 4; ++v) EXPECT_EQ(mesh.tracked.soup.vertex_ids.of(v), v + 1);
  }
}

TEST(FixDefects, TurnedFaceAndInwardSolidAreTurnedBack) {
  const std::array<Index, 2> some{3, 4};
  const Soup cube = shapes::cube();
  EXPECT_NEAR(volume_of(only_mesh(expect_mended(shapes::flipped(cube, some), Flipped))), 1, 1e-15);
  EXPECT_NEAR(volume_of(only_mesh(expect_mended(shapes::flipped(cube), Inward))), 1, 1e-15);
}

TEST(FixDefects, FoldoverIsUnfolded) {
  RepairOptions options;
  options.max_deviation = {2.0, Deviation::Unit::Length};
  const RepairResult result = fix_defects(shapes::dragged_vertex(), options);
  EXPECT_EQ(result.before.count(Foldover), 1U);
  EXPECT_EQ(count_after(result, Foldover), 0U);
  EXPECT_EQ(count_after(result, SelfIntersection), 0U);
}

TEST(FixDefects, OpposedNormalIsRenewedAndTheOthersStay) {
  const Soup good = cube_with_normals();
  Soup soup = good;
  soup.normals[6] = -soup.normals[6];
  const Soup mended = only_mesh(expect_mended(soup, VertexNormal));
  ASSERT_EQ(mended.normals.size(), 8U);
  EXPECT_GT(mended.normals[6].dot(good.normals[6]), 0.0);
  for (const std::size_t v : {0U, 1U, 2U, 3U, 4U, 5U, 7U}) {
    EXPECT_EQ(mended.normals[v], good.normals[v]);
  }
}

TEST(FixDefects, OrphanGoes) {
  Soup soup = shapes::cube();
  soup.positions.emplace_back(9, 9, 9);
  EXPECT_TRUE(same_soup(only_mesh(expect_mended(soup, OrphanVertex)), shapes::cube()));
}

TEST(FixDefects, HoleIsFilled) {
  const RepairResult result = expect_mended(shapes::open_cube(), Hole);
  EXPECT_NEAR(volume_of(only_mesh(result)), 1.0, 1e-15);
  EXPECT_EQ(only_mesh(result).n_faces(), 12U);
}

TEST(FixDefects, OnlyWhatIsAskedForIsFixed) {
  const std::array<Index, 1> one{4};
  const Soup soup = shapes::flipped(shapes::open_cube(), one);
  RepairOptions options;
  options.fixes = {Flipped};
  const RepairResult result = fix_defects(soup, options);
  EXPECT_TRUE(same_soup(only_mesh(result), shapes::open_cube()));
  EXPECT_EQ(count_after(result, Hole), 1U);
  options.fixes = {};
  EXPECT_TRUE(same_soup(only_mesh(fix_defects(soup, options)), soup));
}

TEST(FixDefects, WeldingWithinNoLengthIsRefusedAlsoWhereNothingIsToBeWelded) {
  for (const double no_length : test::kNoLengths) {
    RepairOptions options;
    options.weld_within = no_length;
    EXPECT_THROW(static_cast<void>(fix_defects(shapes::cube(), options)), InvalidArgument);
  }
}

TEST(FixDefects, HoleAtAPointThatIsNotFiniteIsRefused) {
  RepairOptions options;
  options.fill.at = Vec3(0, kNaN, 0);
  EXPECT_THROW(static_cast<void>(fix_defects(shapes::open_cube(), options)), InvalidArgument);
}

TEST(FixDefects, SoupThatContradictsItselfIsRefused) {
  Soup corner = shapes::cube();
  corner.triangles[3][1] = 8;
  EXPECT_THROW(static_cast<void>(fix_defects(corner)), InvalidArgument);
  Soup ids = shapes::cube();
  ids.vertex_ids.named = {1, 2, 3};
  EXPECT_THROW(static_cast<void>(fix_defects(ids)), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
