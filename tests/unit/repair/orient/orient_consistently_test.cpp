#include "meshalyzer/defects/finders.h"
#include "meshalyzer/repair/passes.h"
#include "support/random_soups.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

TEST(OrientConsistently, ConsistentMeshesAreLeft) {
  for (const Soup& soup :
       {Soup{}, shapes::cube(), shapes::flipped(shapes::cube()), shapes::grid(3, 3),
        shapes::fan_of_three(), shapes::two_tetrahedra_sharing_edge()}) {
    const PassRun run = run_pass(soup, orient_consistently);
    EXPECT_EQ(run.operations, 0U);
    EXPECT_TRUE(run.refused.empty());
  }
}

TEST(OrientConsistently, FacesTurnedAtRandomAreTurnedBackAndNoOthers) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    for (const Soup& soup : {shapes::icosphere(2), shapes::torus(20, 1, 30, 3),
                             shapes::nested_cubes(shapes::InnerShell::Cavity)}) {
      std::vector<Index> turned = shapes::permutation(soup.n_faces(), seed);
      turned.resize(turned.size() / 5);
      const PassRun run = run_pass(shapes::flipped(soup, turned), orient_consistently);
      EXPECT_TRUE(same_soup(run.tracked.soup, soup));
      EXPECT_EQ(run.rounds, 1U);
    }
  }
}

TEST(OrientConsistently, MoreThanHalfTurnedLeavesThemAndTurnsTheRest) {
  const Soup sphere = shapes::icosphere(2);
  std::vector<Index> turned = shapes::permutation(sphere.n_faces(), 1);
  turned.resize(turned.size() * 2 / 3);
  const PassRun run = run_pass(shapes::flipped(sphere, turned), orient_consistently);
  EXPECT_TRUE(same_soup(run.tracked.soup, shapes::flipped(sphere)));
}

TEST(OrientConsistently, EachPatchIsAnOperationOfItsOwn) {
  const Soup soup = shapes::grid(4, 4);
  const auto last = static_cast<Index>(soup.n_faces() - 1);
  const PassRun run =
      run_pass(shapes::flipped(soup, std::array{Index{0}, last}), orient_consistently);
  EXPECT_EQ(run.operations, 2U);
  EXPECT_TRUE(same_soup(run.tracked.soup, soup));
}

TEST(OrientConsistently, OneSidedComponentIsRefusedAndOthersAreNot) {
  const Soup soup = shapes::merged(shapes::moebius_strip(7), shapes::cube(1.0, {9, 0, 0}));
  const PassRun run = run_pass(shapes::flipped(soup, std::array{Index{20}}), orient_consistently);
  EXPECT_TRUE(same_soup(run.tracked.soup, soup));
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(run.refused[0].code, DefectCode::Flipped);
  EXPECT_EQ(run.refused[0].face, 0U);
}

TEST(OrientConsistently, NeighboursAtEdgesOfManyFacesAskNothing) {
  const Soup soup = shapes::two_tetrahedra_sharing_edge();
  for (Index f = 0; f < 8; ++f) {
    const PassRun run = run_pass(shapes::flipped(soup, std::array{f}), orient_consistently);
    const PreparedMesh mesh(run.tracked.soup);
    EXPECT_TRUE(find_flipped(mesh).empty());
    EXPECT_EQ(run.rounds, 1U);
  }
}

TEST(OrientConsistently, DamagedMeshesEndConsistentWhereTheyCanBe) {
  std::mt19937 random(5);
  for (int i = 0; i < 30; ++i) {
    const PassRun run = run_pass(damaged(shapes::icosphere(2), 6, random), orient_consistently);
    const PreparedMesh mesh(run.tracked.soup);
    for (const Defect& defect : find_flipped(mesh)) EXPECT_FALSE(defect.fixable);
    EXPECT_LE(run.rounds, 1U);
  }
}

}  // namespace
}  // namespace meshalyzer
