#include "meshalyzer/boolean/make_disjoint.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/defects/check.h"
#include "support/boolean_results.h"
#include "support/no_lengths.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace meshalyzer {
namespace {

using test::verdict_on;
using test::volume_of;

std::vector<DisjointSolid> made_disjoint(const std::vector<Soup>& solids) {
  CombineOptions options;
  options.max_deviation = 1e-3;
  return make_disjoint(solids, options);
}

/// Expects that every two meshes have no point in common.
void expect_apart(const std::vector<DisjointSolid>& solids) {
  for (std::size_t i = 0; i < solids.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_TRUE(check_pair(solids[i].soup, solids[j].soup).empty()) << i << ' ' << j;
    }
  }
}

TEST(MakeDisjoint, EachLosesWhatEarlierOnesHave) {
  // Three cubes in a row, each of which has a half in common with the next.
  const std::vector<Soup> cubes{shapes::cube(2), shapes::cube(2, {1, 0.5, 0.25}),
                                shapes::cube(2, {2, 1, 0.5})};
  const std::vector<DisjointSolid> solids = made_disjoint(cubes);
  ASSERT_EQ(solids.size(), 3U);
  expect_apart(solids);
  EXPECT_EQ(solids[0].soup.positions, cubes[0].positions);
  EXPECT_EQ(solids[0].soup.triangles, cubes[0].triangles);
  EXPECT_EQ(solids[0].largest_move, 0.0);
  // In common with the one before: 1 x 1.5 x 1.75. The first and the third touch in a wall only.
  for (const std::size_t i : {1U, 2U}) {
    EXPECT_EQ(solids[i].outcome, CombineOutcome::Done);
    EXPECT_EQ(verdict_on(solids[i].soup), "good");
    EXPECT_NEAR(volume_of(solids[i].soup), 8 - 1.5 * 1.75, 1e-9);
    EXPECT_LT(solids[i].largest_move, 1e-12);
  }
}

TEST(MakeDisjoint, SolidsApartStayAsTheyAre) {
  const std::vector<Soup> cubes{shapes::cube(), shapes::cube(1, {3, 0, 0})};
  const std::vector<DisjointSolid> solids = made_disjoint(cubes);
  EXPECT_EQ(solids[1].soup.positions, cubes[1].positions);
  EXPECT_EQ(solids[1].soup.triangles, cubes[1].triangles);
}

TEST(MakeDisjoint, SolidInsideOfAnEarlierOneIsGone) {
  const std::vector<Soup> cubes{shapes::cube(3), shapes::cube(1, {1, 1, 1})};
  EXPECT_EQ(made_disjoint(cubes)[1].soup.n_faces(), 0U);
}

/// Expects that a solid without others is good, apart from them, and has a volume.
void expect_parted(const std::vector<Soup>& others, const Soup& solid, double volume) {
  std::vector<Soup> all = others;
  all.push_back(solid);
  const std::vector<DisjointSolid> solids = made_disjoint(all);
  expect_apart(solids);
  EXPECT_EQ(verdict_on(solids.back().soup), "good");
  EXPECT_NEAR(volume_of(solids.back().soup), volume, 0.02);
  EXPECT_LT(solids.back().largest_move, 1e-3);
}

/// A block with a notch in its upper face, which is 0.5 deep.
Soup notched_block(double width) {
  const double half = width / 2;
  const std::vector<Vec3> outline{{0, 0, 0},   {2, 0, 0},        {2, 0, 1}, {1 + half, 0, 1},
                                  {1, 0, 0.5}, {1 - half, 0, 1}, {0, 0, 1}};
  constexpr Index kCorners = 7;
  constexpr Index kBottomOfNotch = 4;
  std::vector<Vec3> positions = outline;
  for (const Vec3& p : outline) positions.emplace_back(p + Vec3(0, 1, 0));
  std::vector<Triangle> triangles;
  for (Index i = 0; i < kCorners; ++i) {
    const Index j = (i + 1) % kCorners;
    triangles.push_back({i, i + kCorners, j + kCorners});
    triangles.push_back({i, j + kCorners, j});
    if (i == kBottomOfNotch || j == kBottomOfNotch) continue;
    triangles.push_back({kBottomOfNotch, i, j});
    triangles.push_back({kBottomOfNotch + kCorners, j + kCorners, i + kCorners});
  }
  return shapes::make(positions, triangles);
}

TEST(MakeDisjoint, SolidIsMovedOutOfANarrowNotch) {
  const Soup block = notched_block(1e-5);
  ASSERT_EQ(verdict_on(block), "good");
  expect_parted({block}, shapes::box({0.5, 0.25, 0.25}, {1.5, 0.75, 1.5}), 0.25);
}

TEST(MakeDisjoint, FilmInAGapIsDropped) {
  // Two cubes with a gap of four units in the last place between them, in a block round both.
  const double gap = 0x1p-50;
  expect_parted({shapes::cube(), shapes::cube(1, {1 + gap, 0, 0})},
                shapes::box({-0.5, -0.5, -0.5}, {2.5, 1.5, 1.5}), 12.0 - 2.0);
}

TEST(MakeDisjoint, FilmOnAWallIsDropped) {
  // The block reaches above the cube that is taken from it by less than it is moved off that.
  expect_parted({shapes::cube()}, shapes::box({-1, 0.25, 0.25}, {2, 0.75, 1 + 0x1p-48}),
                3 * 0.375 - 0.375);
}

PartedDifference subtracted(const Soup& solid, const Soup& other) {
  const std::vector<Soup> both{solid, other};
  const Soup all = concatenate(both);
  CombineOptions options;
  options.max_deviation = 1e-3;
  return subtract_and_part(operands_of(all, both), other, options);
}

TEST(SubtractAndPart, TellsHowFarItCutBack) {
  const PartedDifference moved =
      subtracted(shapes::box({-1, 0.25, 0.25}, {2, 0.75, 0.75}), shapes::cube());
  EXPECT_GT(moved.n_moved, 0U);
  EXPECT_EQ(moved.cut_back, 0.0);
  EXPECT_LT(moved.solid.largest_move, 1e-12);
  const PartedDifference cut =
      subtracted(shapes::box({-1, 0.25, 0.25}, {2, 0.75, 1 + 0x1p-48}), shapes::cube());
  EXPECT_GT(cut.cut_back, 0.0);
  EXPECT_LE(cut.cut_back, 1e-3 / 2);
  EXPECT_GE(cut.solid.largest_move, cut.cut_back);
}

TEST(MakeDisjoint, SolidThatCannotBeCutStays) {
  const std::vector<Soup> cubes{shapes::cube(), shapes::cube(1, {0.5, 0.5, 0.5})};
  CombineOptions options;
  options.max_pairs = 1;
  const std::vector<DisjointSolid> solids = make_disjoint(cubes, options);
  EXPECT_EQ(solids[1].outcome, CombineOutcome::TooManyPairs);
  EXPECT_EQ(solids[1].soup.triangles, cubes[1].triangles);
}

TEST(MakeDisjoint, DeviationThatIsNoLengthIsRefusedAlsoWhereNothingMeets) {
  const std::vector<Soup> one{shapes::cube()};
  for (const double no_length : test::kNoLengths) {
    EXPECT_THROW(static_cast<void>(make_disjoint(one, {.max_deviation = no_length})),
                 InvalidArgument)
        << no_length;
  }
}

TEST(SubtractInOrder, StepThatIsNullIsRefused) {
  EXPECT_THROW(subtract_in_order({}, SubtractStep()), InvalidArgument);
}

TEST(MakeDisjoint, SolidThatContradictsItselfIsRefusedAlsoWhereItIsAlone) {
  Soup wrong = shapes::cube();
  wrong.triangles[3][1] = 8;
  EXPECT_THROW(static_cast<void>(make_disjoint(std::vector<Soup>{wrong})), InvalidArgument);
}

TEST(MakeDisjoint, PositionThatIsNotFiniteIsRefusedAlsoInASolidThatIsAlone) {
  Soup wrong = shapes::cube();
  wrong.positions[1].z() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(make_disjoint(std::vector<Soup>{wrong})), InvalidArgument);
  EXPECT_THROW(static_cast<void>(operands_of(wrong)), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
