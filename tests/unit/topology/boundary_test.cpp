#include "meshalyzer/topology/boundary.h"

#include "direct_evaluation.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/topology/border.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

using Walk = std::vector<direct::Edge>;

std::vector<Walk> walks_of(const Soup& soup) {
  const CutMesh cut = build(soup);
  std::vector<Walk> walks;
  const BoundaryLoops loops = find_boundary_loops(cut);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    Walk& walk = walks.emplace_back();
    for (const HalfedgeHandle h : loops[i].halfedges) walk.push_back(direct::edge_of(cut, h));
  }
  return walks;
}

bool have_common_end(const direct::Edge& a, const direct::Edge& b) {
  return a.first == b.first || a.first == b.second || a.second == b.first || a.second == b.second;
}

TEST(FindBoundaryLoops, ClosedMeshHasNone) {
  EXPECT_TRUE(walks_of(shapes::icosphere(1)).empty());
  EXPECT_TRUE(walks_of(shapes::projective_plane()).empty());
  EXPECT_TRUE(walks_of(shapes::two_tetrahedra_sharing_face()).empty());
  EXPECT_TRUE(walks_of(Soup{}).empty());
}

TEST(FindBoundaryLoops, SingleFaceIsWalkedRound) {
  const Soup soup = shapes::make(std::vector<Vec3>(3, Vec3::Zero()), {{0, 1, 2}});
  EXPECT_EQ(walks_of(soup), (std::vector<Walk>{{{0, 1}, {1, 2}, {0, 2}}}));
}

TEST(FindBoundaryLoops, OpenCubeIsWalkedFromItsLowestEdge) {
  // The rim of the top, which has the vertices 4 5 7 6 round it; its faces run along it from 5
  // to 4.
  EXPECT_EQ(walks_of(shapes::open_cube()), (std::vector<Walk>{{{4, 5}, {4, 6}, {6, 7}, {5, 7}}}));
}

TEST(FindBoundaryLoops, EveryHoleIsOne) {
  // Faces that have no vertex in common.
  const Soup sphere = shapes::uv_sphere(12, 12);
  const std::array<Index, 3> faces{0, 100, 200};
  const std::vector<Walk> walks = walks_of(shapes::without_faces(sphere, faces));
  ASSERT_EQ(walks.size(), 3U);
  for (const Walk& walk : walks) EXPECT_EQ(walk.size(), 3U);
}

TEST(FindBoundaryLoops, SheetsThatTouchAtAVertexKeepTheirOwn) {
  const Soup soup = shapes::make(std::vector<Vec3>(5, Vec3::Zero()), {{0, 1, 2}, {0, 3, 4}});
  EXPECT_EQ(walks_of(soup),
            (std::vector<Walk>{{{0, 1}, {1, 2}, {0, 2}}, {{0, 3}, {3, 4}, {0, 4}}}));
}

TEST(FindBoundaryLoops, HolesThatTouchAtAVertexAreOne) {
  // A grid of 4 x 4 squares without the two that touch at the middle from the lower left and the
  // upper right. The fans at the middle are those of the other two squares there, and each has an
  // edge of either hole: a walk round one hole goes on round the other.
  const std::array<Index, 4> faces{10, 11, 20, 21};
  const std::vector<Walk> walks = walks_of(shapes::without_faces(shapes::grid(4, 4), faces));
  ASSERT_EQ(walks.size(), 2U);
  EXPECT_EQ(walks[0].size(), 16U);
  EXPECT_EQ(walks[1].size(), 8U);
}

TEST(FindBoundaryLoops, FlippedFaceInsideADiscLeavesOneBoundary) {
  for (Index face = 0; face < 18; ++face) {
    SCOPED_TRACE(face);
    const std::vector<Walk> walks = walks_of(shapes::flipped(shapes::grid(3, 3), std::array{face}));
    ASSERT_EQ(walks.size(), 1U);
    EXPECT_EQ(walks[0].size(), 12U);
  }
}

TEST(FindBoundaryLoops, MoebiusStripHasOne) {
  const std::vector<Walk> walks = walks_of(shapes::moebius_strip(7));
  ASSERT_EQ(walks.size(), 1U);
  EXPECT_EQ(walks[0].size(), 14U);
}

TEST(FindBoundaryLoops, FanOfThreeHasAChainForEachFace) {
  const CutMesh cut = build(shapes::fan_of_three());
  const BoundaryLoops loops = find_boundary_loops(cut);
  ASSERT_EQ(loops.size(), 3U);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    EXPECT_EQ(loops[i].shape, BoundaryShape::Chain);
    EXPECT_EQ(loops[i].halfedges.size(), 2U);
  }
}

TEST(FindBoundaryLoops, ChainBeginsWithOneOfItsEnds) {
  // Three half-strips on the edge 0-1, each of two faces and three border edges. The lowest of the
  // first is 0-2, walked from 2 to 0 for the face 0 1 2 leaves it so.
  const Soup soup =
      shapes::make(std::vector<Vec3>(8, Vec3::Zero()),
                   {{0, 1, 5}, {0, 5, 2}, {0, 1, 6}, {0, 6, 3}, {0, 1, 7}, {0, 7, 4}});
  EXPECT_EQ(walks_of(soup),
            (std::vector<Walk>{
                {{1, 5}, {2, 5}, {0, 2}}, {{1, 6}, {3, 6}, {0, 3}}, {{1, 7}, {4, 7}, {0, 4}}}));
}

TEST(FindBoundaryLoops, OrderOfTheFacesChangesNothing) {
  Soup soup = shapes::merged(shapes::open_cube(), shapes::moebius_strip(5));
  soup = shapes::merged(soup, shapes::fan_of_three());
  const auto as_sets = [](const std::vector<Walk>& walks) {
    std::vector<std::set<direct::Edge>> sets;
    for (const Walk& walk : walks) sets.emplace_back(walk.begin(), walk.end());
    return sets;
  };
  const auto expected = as_sets(walks_of(soup));
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    EXPECT_EQ(as_sets(walks_of(shapes::shuffled_faces(soup, seed))), expected);
  }
}

TEST(FindBoundaryLoops, AgreesWithDirectEvaluationOnRandomSoups) {
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    const Soup soup = direct::random_soup(seed, 1 + seed % 20);
    std::set<std::set<direct::Edge>> found;
    std::size_t n_walked = 0;
    for (const Walk& walk : walks_of(soup)) {
      found.emplace(walk.begin(), walk.end());
      n_walked += walk.size();
    }
    const direct::Complex complex = direct::complex_of(soup);
    EXPECT_EQ(found, direct::boundaries(complex));
    EXPECT_EQ(n_walked, direct::edges_with(complex, 1).size());
  }
}

TEST(FindBoundaryLoops, WalksStepFromEdgeToEdgeInRandomSoups) {
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    const CutMesh cut = build(direct::random_soup(seed, 1 + seed % 20));
    std::vector<direct::Edge> lowest;
    const BoundaryLoops loops = find_boundary_loops(cut);
    for (std::size_t k = 0; k < loops.size(); ++k) {
      const BoundaryLoop loop = loops[k];
      Walk walk;
      for (const HalfedgeHandle h : loop.halfedges) walk.push_back(direct::edge_of(cut, h));
      for (std::size_t i = 1; i < walk.size(); ++i) {
        EXPECT_TRUE(have_common_end(walk[i - 1], walk[i]));
      }
      lowest.push_back(*std::min_element(walk.begin(), walk.end()));
      if (loop.shape == BoundaryShape::Chain) continue;
      EXPECT_TRUE(have_common_end(walk.back(), walk.front()));
      EXPECT_EQ(walk.front(), lowest.back());
    }
    EXPECT_TRUE(std::is_sorted(lowest.begin(), lowest.end()));
  }
}

}  // namespace
}  // namespace meshalyzer
