#include "meshalyzer/repair/passes.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"
#include "unit/repair/facets/mended_meshes.h"
#include "unit/repair/overlapping_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

std::size_t n_duplicate_sets(const Soup& soup) {
  return find_duplicate_facets(PreparedMesh(soup)).size();
}

/// Two cubes side by side that share the four vertices of a square, which both have: two faces
/// each, opposed. The cubes are [0, 1]^3 and [1, 1 + width] x [0, 1]^2.
Soup cubes_sharing_a_side(double width) {
  // x is the slowest: vertices 4 x + 2 y + z.
  Soup soup;
  for (const double x : {0.0, 1.0, 1.0 + width}) {
    for (const double y : {0.0, 1.0}) {
      for (const double z : {0.0, 1.0}) soup.positions.emplace_back(x, y, z);
    }
  }
  const auto side = [&](Index a, Index b, Index c, Index d) {
    soup.triangles.push_back({a, b, c});
    soup.triangles.push_back({a, c, d});
  };
  for (const Index v : {Index{0}, Index{4}}) {
    side(v, v + 4, v + 5, v + 1);
    side(v + 2, v + 3, v + 7, v + 6);
    side(v, v + 2, v + 6, v + 4);
    side(v + 1, v + 5, v + 7, v + 3);
  }
  side(0, 1, 3, 2);
  side(8, 10, 11, 9);
  // The wall, cut along the same diagonal from both sides.
  side(4, 6, 7, 5);
  for (const Triangle t : {Triangle{4, 7, 6}, Triangle{4, 5, 7}}) soup.triangles.push_back(t);
  return soup;
}

TEST(DropDuplicates, MeshWithoutDuplicatesIsLeft) {
  for (const Soup& soup : {shapes::cube(), shapes::tetrahedron(), shapes::grid(3, 3), Soup{}}) {
    EXPECT_TRUE(same_soup(run_pass(soup, drop_duplicates).tracked.soup, soup));
  }
}

TEST(DropDuplicates, FaceGivenAgainIsDropped) {
  Soup soup = shapes::cube();
  soup.triangles.push_back({soup.triangles[3][1], soup.triangles[3][2], soup.triangles[3][0]});
  soup.triangles.push_back(soup.triangles[3]);
  const PassRun run = run_pass(soup, drop_duplicates);
  EXPECT_EQ(run.operations, 1U);
  EXPECT_TRUE(same_soup(run.tracked.soup, shapes::cube()));
}

TEST(DropDuplicates, FaceThatFitsItsNeighboursStaysThoughItIsNotTheFirst) {
  Soup soup = shapes::cube();
  const Triangle t = soup.triangles[0];
  soup.triangles.push_back(t);
  std::swap(soup.triangles[0][0], soup.triangles[0][1]);
  const PassRun run = run_pass(soup, drop_duplicates);
  EXPECT_EQ(n_duplicate_sets(run.tracked.soup), 0U);
  EXPECT_EQ(topology_of(run.tracked.soup), topology_of(shapes::cube()));
  EXPECT_EQ(run.tracked.soup.triangles.back(), t);
}

TEST(DropDuplicates, PillowGoesAsAWhole) {
  // One of its faces alone would be open.
  const Soup soup = shapes::merged(shapes::cube(), shapes::pillow());
  const PassRun run = run_pass(soup, drop_duplicates);
  EXPECT_EQ(run.tracked.soup.n_faces(), 12U);
  EXPECT_EQ(run.operations, 1U);
}

TEST(DropDuplicates, PillowKeepsAFaceOfEachDirectionWhereOnlySurplusIsDropped) {
  const Soup pillow = shapes::merged(shapes::cube(), shapes::pillow());
  EXPECT_TRUE(same_soup(run_pass(pillow, drop_surplus_duplicates).tracked.soup, pillow));

  Soup soup = pillow;
  for (const std::size_t face : {12U, 13U, 13U, 12U})
    soup.triangles.push_back(soup.triangles[face]);
  EXPECT_TRUE(same_soup(run_pass(soup, drop_surplus_duplicates).tracked.soup, pillow));
}

TEST(DropDuplicates, WallOfTwoSolidsIsRefusedWhereItsMiddleIsFarFromAllElse) {
  const Soup soup = shapes::two_tetrahedra_sharing_face();
  const PassRun run = run_pass(soup, drop_duplicates);
  EXPECT_TRUE(same_soup(run.tracked.soup, soup));
  EXPECT_EQ(run.refused.size(), 1U);
}

TEST(DropDuplicates, WallOfTwoSolidsStaysWhereAThirdOneTouchesItsRim) {
  Soup soup = shapes::two_tetrahedra_sharing_face();
  const auto p = static_cast<Index>(soup.n_vertices());
  soup.positions.emplace_back(0.3, -1, -0.5);
  soup.positions.emplace_back(0.3, -1, 0.5);
  // A tetrahedron at the edge 0-1.
  for (const Triangle& t :
       std::vector<Triangle>{{0, 1, p}, {1, 0, p + 1}, {0, p, p + 1}, {1, p + 1, p}}) {
    soup.triangles.push_back(t);
  }
  const PassRun run = run_pass(soup, drop_duplicates);
  EXPECT_TRUE(same_soup(run.tracked.soup, soup));
  EXPECT_EQ(run.refused.size(), 1U);
}

TEST(DropDuplicates, WallWithinTheDeviationGoesAndTheSolidsAreOne) {
  const Soup soup = shapes::two_tetrahedra_sharing_face();
  RepairLimits limits = wide_limits(soup);
  limits.max_deviation = 2.0;
  const PassRun run = run_pass(soup, drop_duplicates, limits);
  EXPECT_EQ(run.tracked.soup.n_faces(), 6U);
  const TopologyCounts topology = topology_of(run.tracked.soup);
  EXPECT_EQ(topology.euler_characteristic, 2);
  EXPECT_EQ(topology.boundaries, 0U);
  EXPECT_EQ(topology.non_manifold_vertices, 0U);
}

TEST(DropDuplicates, WallOfSeveralFacesGoesAsAWhole) {
  const Soup soup = cubes_sharing_a_side(1.0);
  RepairLimits limits = wide_limits(soup);
  limits.max_deviation = 2.0;
  const PassRun run = run_pass(soup, drop_duplicates, limits);
  EXPECT_EQ(run.operations, 1U);
  EXPECT_EQ(run.tracked.soup.n_faces(), 20U);
  EXPECT_EQ(topology_of(run.tracked.soup).euler_characteristic, 2);
  EXPECT_EQ(topology_of(run.tracked.soup).non_manifold_vertices, 0U);
}

TEST(DropDuplicates, WallOfWhichAFaceIsGivenAgainKeepsOneOfEachDirection) {
  Soup soup = cubes_sharing_a_side(1.0);
  // The last face and its opposite, the second of the side before.
  const Triangle last = soup.triangles.back();
  soup.triangles.push_back(last);
  soup.triangles.push_back({last[1], last[0], last[2]});
  const PassRun run = run_pass(soup, drop_duplicates);
  EXPECT_TRUE(same_soup(run.tracked.soup, cubes_sharing_a_side(1.0)));
  EXPECT_EQ(run.refused.size(), 2U);
}

TEST(DropDuplicates, CommonSideOfOverlappingSolidsIsRefused) {
  const Soup soup = boxes_with_a_common_side();
  const PassRun run = run_pass(soup, drop_duplicates);
  EXPECT_TRUE(same_soup(run.tracked.soup, soup));
  ASSERT_EQ(run.refused.size(), 2U);
  EXPECT_EQ(run.refused.front().reason,
            "it is a side of two solids that overlap, and each needs it");
}

TEST(DropDuplicates, SolidGivenTwiceIsLeftOnce) {
  Soup soup = shapes::cube();
  const std::vector<Triangle> once = soup.triangles;
  soup.triangles.insert(soup.triangles.end(), once.begin(), once.end());
  EXPECT_TRUE(same_soup(run_pass(soup, drop_duplicates).tracked.soup, shapes::cube()));
}

TEST(DropDuplicates, PairInAnOpenPlaceIsNoWall) {
  // Without one of the cubes' other faces the rest is not closed round the wall.
  Soup soup = cubes_sharing_a_side(1.0);
  // Face 0 is on the edge 0 4; face 6 on the edges 4 6 and 0 6: the wall's rim.
  const std::vector<Index> hole{5};
  soup = shapes::without_faces(soup, hole);
  const PassRun run = run_pass(soup, drop_duplicates);
  EXPECT_EQ(n_duplicate_sets(run.tracked.soup), 0U);
}

/// Counts the sets of equal faces, as many of one orientation as of the other, that are the only
/// faces at their edges.
std::size_t n_pillows(const Soup& soup) {
  std::map<Triangle, int> balance;
  std::map<Triangle, std::size_t> n_equal;
  std::map<std::pair<Index, Index>, std::size_t> n_at_edge;
  for (const Triangle& t : soup.triangles) {
    Triangle sorted = t;
    std::sort(sorted.begin(), sorted.end());
    Triangle turned = t;
    std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
    balance[sorted] += turned == sorted ? 1 : -1;
    ++n_equal[sorted];
    for (std::size_t k = 0; k < 3; ++k) ++n_at_edge[std::minmax({t[k], t[(k + 1) % 3]})];
  }
  return static_cast<std::size_t>(
      std::count_if(n_equal.begin(), n_equal.end(), [&](const auto& set) {
        const auto& [t, n] = set;
        return balance.at(t) == 0 && n_at_edge.at({t[0], t[1]}) == n &&
               n_at_edge.at({t[1], t[2]}) == n && n_at_edge.at({t[0], t[2]}) == n;
      }));
}

TEST(DropDuplicates, RandomRepeatsLeaveNoDuplicates) {
  std::mt19937 random(31);
  for (int i = 0; i < 50; ++i) {
    const Soup soup = damaged(shapes::torus(3.0, 1.0, 8, 6), 5, random);
    const PassRun run = run_pass(soup, drop_duplicates);
    EXPECT_EQ(n_duplicate_sets(run.tracked.soup), run.refused.size());
    EXPECT_LE(run.rounds, 1U);
    // Each set of three vertices is still there, but for pillows.
    std::vector<Triangle> before = soup.triangles;
    for (Triangle& t : before) std::sort(t.begin(), t.end());
    std::sort(before.begin(), before.end());
    before.erase(std::unique(before.begin(), before.end()), before.end());
    EXPECT_EQ(run.tracked.soup.n_faces() - run.refused.size(), before.size() - n_pillows(soup));
  }
}

}  // namespace
}  // namespace meshalyzer
