#include "meshalyzer/defects/boundary_chains.h"

#include "meshalyzer/base/error.h"
#include "support/constants.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

std::vector<BoundaryChain> chains_of(const Soup& soup, const ChainOptions& options = {}) {
  return find_boundary_chains(PreparedMesh(soup), options);
}

TEST(FindBoundaryChains, ClosedMeshHasNone) {
  EXPECT_TRUE(chains_of(shapes::cube()).empty());
  EXPECT_TRUE(chains_of(Soup{}).empty());
  EXPECT_TRUE(chains_of(shapes::cube(), {.near_positions = {Vec3::Zero()}}).empty());
}

TEST(FindBoundaryChains, OpenCubeHasItsRimWithTheFacesToTheLeft) {
  const std::vector<BoundaryChain> chains = chains_of(shapes::open_cube());
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_TRUE(chains[0].is_closed);
  // The faces below the rim run along it from 5 to 4, 4 to 6, 6 to 7 and 7 to 5.
  EXPECT_EQ(chains[0].vertices, (std::vector<Index>{5, 4, 6, 7}));
}

TEST(FindBoundaryChains, HolesThatTouchAtAVertexComeApart) {
  // See FindBoundaryLoops: they are one boundary, which passes the middle twice.
  const std::array<Index, 4> faces{10, 11, 20, 21};
  const std::vector<BoundaryChain> chains =
      chains_of(shapes::without_faces(shapes::grid(4, 4), faces));
  ASSERT_EQ(chains.size(), 3U);
  EXPECT_EQ(chains[0].vertices.size(), 16U);
  EXPECT_EQ(chains[1].vertices.size(), 4U);
  EXPECT_EQ(chains[2].vertices.size(), 4U);
  for (const BoundaryChain& chain : chains) EXPECT_TRUE(chain.is_closed);
}

TEST(FindBoundaryChains, ChainsEndAtNonManifoldEdges) {
  const std::vector<BoundaryChain> chains = chains_of(shapes::fan_of_three());
  ASSERT_EQ(chains.size(), 3U);
  for (const BoundaryChain& chain : chains) {
    EXPECT_FALSE(chain.is_closed);
    EXPECT_EQ(chain.vertices.size(), 3U);
  }
}

TEST(FindBoundaryChains, LongOnesCanBeLeftOut) {
  const std::array<Index, 2> faces{10, 11};
  const Soup soup = shapes::without_faces(shapes::grid(4, 4), faces);
  EXPECT_EQ(chains_of(soup).size(), 2U);
  EXPECT_EQ(chains_of(soup, {.max_edges = 4}).size(), 1U);
  EXPECT_TRUE(chains_of(soup, {.max_edges = 3}).empty());
}

TEST(FindBoundaryChains, NearestOfEachPositionIsGivenOnce) {
  const std::array<Index, 2> faces{10, 11};
  const Soup soup = shapes::without_faces(shapes::grid(4, 4), faces);
  const Vec3 inside(1.5, 1.5, 3.0);
  const Vec3 outside(-1.0, 2.0, 0.0);
  const auto first_two = chains_of(soup, {.near_positions = {inside, outside, inside}});
  ASSERT_EQ(first_two.size(), 2U);
  EXPECT_EQ(first_two[0].vertices.size(), 4U);
  EXPECT_EQ(first_two[1].vertices.size(), 16U);
  EXPECT_EQ(chains_of(soup, {.near_positions = {outside}})[0].vertices.size(), 16U);
}

TEST(FindBoundaryChains, AreSimpleAndHoldEveryBorderEdgeOnce) {
  std::mt19937 random(41);
  for (int i = 0; i < 60; ++i) {
    const Soup soup = damaged(shapes::grid(6, 6), 4, random);
    std::multiset<std::array<Index, 2>> sides;
    for (const Triangle& t : soup.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        sides.insert({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
      }
    }
    std::set<std::array<Index, 2>> expected;
    for (const auto& side : sides) {
      if (sides.count(side) == 1) expected.insert(side);
    }
    std::multiset<std::array<Index, 2>> found;
    for (const BoundaryChain& chain : chains_of(soup)) {
      const std::set<Index> distinct(chain.vertices.begin(), chain.vertices.end());
      EXPECT_EQ(distinct.size(), chain.vertices.size());
      for (std::size_t k = chain.is_closed ? 0 : 1; k < chain.vertices.size(); ++k) {
        const Index a = chain.vertices[k == 0 ? chain.vertices.size() - 1 : k - 1];
        found.insert({std::min(a, chain.vertices[k]), std::max(a, chain.vertices[k])});
      }
    }
    EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
  }
}

TEST(FindBoundaryChains, PositionThatIsNotFiniteIsRefused) {
  const Vec3 wrong(0, 0, kNaN);
  EXPECT_THROW(chains_of(shapes::open_cube(), {.near_positions = {wrong}}), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
