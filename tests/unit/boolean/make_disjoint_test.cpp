#include "meshalyzer/boolean/make_disjoint.h"

#include "meshalyzer/defects/check.h"
#include "support/boolean_results.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstddef>
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

TEST(MakeDisjoint, SolidThatCannotBeCutStays) {
  const std::vector<Soup> cubes{shapes::cube(), shapes::cube(1, {0.5, 0.5, 0.5})};
  CombineOptions options;
  options.max_pairs = 1;
  const std::vector<DisjointSolid> solids = make_disjoint(cubes, options);
  EXPECT_EQ(solids[1].outcome, CombineOutcome::TooManyPairs);
  EXPECT_EQ(solids[1].soup.triangles, cubes[1].triangles);
}

}  // namespace
}  // namespace meshalyzer
