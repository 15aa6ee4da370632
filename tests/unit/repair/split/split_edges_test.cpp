#include "meshalyzer/repair/passes.h"
#include "support/random_soups.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"
#include "support/soups.h"
#include "unit/repair/cell_complex.h"
#include "unit/repair/split/split_passes.h"
#include "unit/repair/voxel_solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The cube of side 2, with a vertex in the middle of the edge from (0,0,0) to (2,0,0) and of the
/// one from (0,0,2) to (2,0,2), and a triangle of vertices 8, 9 and a new one.
Soup cube_with_triangle(const Vec3& third) {
  Soup soup = shapes::cube(2.0);
  soup.positions.emplace_back(1, 0, 0);
  soup.positions.emplace_back(1, 0, 2);
  soup.positions.push_back(third);
  std::vector<Triangle> triangles;
  // The front, y = 0, of corners 0, 1, 5, 4; its neighbours below and above get the new vertices.
  for (const Triangle& t : std::vector<Triangle>{{0, 8, 9}, {0, 9, 4}, {8, 1, 5}, {8, 5, 9}}) {
    triangles.push_back(t);
  }
  for (const Triangle& t :
       std::vector<Triangle>{{0, 2, 8}, {2, 3, 8}, {3, 1, 8}, {4, 9, 6}, {9, 7, 6}, {9, 5, 7}}) {
    triangles.push_back(t);
  }
  for (const Triangle& t :
       std::vector<Triangle>{{1, 3, 7}, {1, 7, 5}, {3, 2, 6}, {3, 6, 7}, {2, 0, 4}, {2, 4, 6}}) {
    triangles.push_back(t);
  }
  triangles.push_back({8, 9, 10});
  soup.triangles = std::move(triangles);
  return soup;
}

TEST(SplitEdges, ManifoldMeshesAreLeft) {
  for (const Soup& soup : {shapes::cube(), shapes::moebius_strip(5), shapes::pillow(), Soup{},
                           shapes::two_tetrahedra_sharing_vertex(), shapes::open_cube()}) {
    EXPECT_TRUE(same_soup(run_pass(soup, split_edges_and_walls).tracked.soup, soup));
  }
}

TEST(SplitEdges, TetrahedraWithACommonEdgeComeApart) {
  const Soup soup = shapes::two_tetrahedra_sharing_edge();
  const PassRun run = run_pass(soup, split_edges_and_walls);
  EXPECT_EQ(run.operations, 1U);
  EXPECT_EQ(run.rounds, 1U);
  EXPECT_TRUE(is_cut_version(run.tracked.soup, soup));
  EXPECT_TRUE(is_manifold(run.tracked.soup));
  EXPECT_EQ(n_border_edges(run.tracked.soup), 0U);
  // Each is the corner of a cube: 1/6. The first keeps its vertices.
  EXPECT_EQ(volumes(run.tracked.soup), (std::vector<double>{1.0 / 6, 1.0 / 6}));
  for (std::size_t f = 0; f < 4; ++f) {
    EXPECT_EQ(run.tracked.soup.triangles[f], soup.triangles[f]);
  }
}

TEST(SplitEdges, TetrahedraBackToBackOnAFaceThatIsThereTwiceComeApart) {
  const PassRun run = run_pass(shapes::two_tetrahedra_sharing_face(), split_edges_and_walls);
  EXPECT_EQ(run.operations, 1U);
  EXPECT_TRUE(is_manifold(run.tracked.soup));
  EXPECT_EQ(volumes(run.tracked.soup), (std::vector<double>{1.0 / 6, 1.0 / 6}));
}

TEST(SplitEdges, WallThatIsStoredOnceBetweenTwoTetrahedraIsDoubled) {
  // The wall, face 4 now, is oriented like a side of either.
  for (const Index dropped : {0U, 4U}) {
    const std::array<Index, 1> faces{dropped};
    const Soup soup = shapes::without_faces(shapes::two_tetrahedra_sharing_face(), faces);
    const PassRun run = run_pass(soup, split_edges_and_walls);
    EXPECT_TRUE(is_manifold(run.tracked.soup));
    EXPECT_EQ(volumes(run.tracked.soup), (std::vector<double>{1.0 / 6, 1.0 / 6}));
    EXPECT_EQ(n_border_edges(run.tracked.soup), 0U);
  }
}

TEST(SplitEdges, WallStaysWithOneCellWhereItIsNotToBeDoubled) {
  const std::array<Index, 1> faces{4U};
  const Soup soup = shapes::without_faces(shapes::two_tetrahedra_sharing_face(), faces);
  const PassRun run =
      run_pass(soup, [](const PassInput& input) { return split_edges(input, SharedWalls::Left); });
  EXPECT_TRUE(is_manifold(run.tracked.soup));
  EXPECT_EQ(volumes(run.tracked.soup), (std::vector<double>{0.0, 1.0 / 3}));
  EXPECT_EQ(n_border_edges(run.tracked.soup), 3U);
}

TEST(SplitEdges, CellsOfAnyComplexComeApart) {
  std::mt19937 random(5);
  for (int i = 0; i < 20; ++i) {
    const CellComplex complex = random_complex({2, 3, 3}, 3, random);
    const CellComplex::Faces faces = complex.faces();
    const PassRun run = split(faces.soup);
    EXPECT_TRUE(is_manifold(run.tracked.soup)) << i;
    EXPECT_EQ(n_border_edges(run.tracked.soup), 0U) << i;
    EXPECT_EQ(run.tracked.soup.n_faces(), faces.soup.n_faces() + faces.walls.size()) << i;
    const std::vector<double> of_parts = volumes(run.tracked.soup);
    EXPECT_EQ(of_parts.size(), complex.n_parts()) << i;
    EXPECT_EQ(std::accumulate(of_parts.begin(), of_parts.end(), 0.0), complex.volume()) << i;
  }
}

TEST(SplitEdges, CellsComeApartWhereverTheirFacesPoint) {
  std::mt19937 random(6);
  for (int i = 0; i < 20; ++i) {
    const CellComplex complex = random_complex({2, 3, 3}, 3, random);
    CellComplex::Faces faces = complex.faces();
    for (Triangle& t : faces.soup.triangles) {
      if (i % 2 == 0 || random() % 2 == 0) std::swap(t[0], t[1]);
    }
    const PassRun run = split(faces.soup);
    EXPECT_TRUE(is_manifold(run.tracked.soup)) << i;
    EXPECT_EQ(n_border_edges(run.tracked.soup), 0U) << i;
    EXPECT_EQ(n_components(run.tracked.soup), complex.n_parts()) << i;
    // Faces keep their direction.
    for (std::size_t f = 0; f < faces.soup.n_faces(); ++f) {
      EXPECT_EQ(run.tracked.soup.positions[run.tracked.soup.triangles[f][0]],
                faces.soup.positions[faces.soup.triangles[f][0]]);
      EXPECT_EQ(run.tracked.soup.positions[run.tracked.soup.triangles[f][1]],
                faces.soup.positions[faces.soup.triangles[f][1]]);
    }
  }
}

TEST(SplitEdges, WallThatEndsOnTheBorderOfABodyIsNotDoubled) {
  const std::array<Index, 1> faces{4U};
  const Soup soup = shapes::without_faces(shapes::two_tetrahedra_sharing_face(), faces);
  const Triangle wall = soup.triangles[0];
  const PassRun run =
      run_pass(soup, split_edges_and_walls, body_limits(soup, {wall[0], wall[1], wall[2]}));
  EXPECT_EQ(run.tracked.soup.n_faces(), soup.n_faces());
}

TEST(SplitEdges, FinOutsideOrInsideACubeIsCutOff) {
  for (const double y : {-1.0, 1.0}) {
    const Soup soup = cube_with_triangle({1, y, 1});
    const PassRun run = run_pass(soup, split_edges_and_walls);
    EXPECT_EQ(run.operations, 1U);
    EXPECT_TRUE(is_manifold(run.tracked.soup));
    EXPECT_EQ(n_border_edges(run.tracked.soup), 3U);
    ASSERT_EQ(volumes(run.tracked.soup).size(), 2U);
    EXPECT_EQ(volumes(run.tracked.soup)[1], 8.0);
  }
}

TEST(SplitEdges, ThreeFacesOnAnEdgeBecomeTwoAndOne) {
  const PassRun run = run_pass(shapes::fan_of_three(), split_edges_and_walls);
  EXPECT_TRUE(is_manifold(run.tracked.soup));
  EXPECT_EQ(n_components(run.tracked.soup), 2U);
  // The faces are at 0, 135 and 225 degrees: the second goes on from the first as evenly as the
  // third does, and comes before it.
  EXPECT_EQ(run.tracked.soup.triangles[1], (Triangle{0, 1, 3}));
}

TEST(SplitEdges, BoxesInAChainComeApartLinkByLink) {
  VoxelSolid solid({4, 4, 1});
  for (int i = 0; i < 4; ++i) solid.fill({i, i, 0});
  const PassRun run = run_pass(solid.surface(), split_edges_and_walls);
  EXPECT_EQ(run.rounds, 1U);
  EXPECT_EQ(volumes(run.tracked.soup), (std::vector<double>{1, 1, 1, 1}));
}

TEST(SplitEdges, FourBoxesRoundAnEdgeAreNone) {
  VoxelSolid solid({2, 2, 1});
  for (int x = 0; x < 2; ++x) {
    for (int y = 0; y < 2; ++y) solid.fill({x, y, 0});
  }
  EXPECT_EQ(run_pass(solid.surface(), split_edges_and_walls).operations, 0U);
}

TEST(SplitEdges, BoxesThatAreJoinedAtBothEndsOfASingleEdgeGetNoEdgeTwice) {
  // Between two slabs stand two boxes that meet in an edge. Its ends lie inside the slabs, so that
  // each has but one fan if the boxes come apart; so the two gaps beside them do.
  VoxelSolid solid({2, 2, 3});
  for (int x = 0; x < 2; ++x) {
    for (int y = 0; y < 2; ++y) {
      solid.fill({x, y, 0});
      solid.fill({x, y, 2});
    }
    solid.fill({x, x, 1});
  }
  const Soup soup = solid.surface();
  const PassRun run = run_pass(soup, split_edges_and_walls);
  EXPECT_TRUE(is_manifold(run.tracked.soup));
  EXPECT_EQ(n_border_edges(run.tracked.soup), 0U);
  EXPECT_EQ(run.tracked.soup.n_vertices(), soup.n_vertices() + 2);
  EXPECT_EQ(volumes(run.tracked.soup), std::vector<double>{10});
}

TEST(SplitEdges, SeparatePlacesAreSeparateOperations) {
  const Soup one = shapes::two_tetrahedra_sharing_edge();
  const Soup two = shapes::merged(one, shapes::translated(one, {5, 0, 0}));
  EXPECT_EQ(run_pass(two, split_edges_and_walls).operations, 2U);
}

TEST(SplitEdges, EdgeWithBothEndsFixedIsRefusedWithOneItIsSplit) {
  const Soup soup = shapes::two_tetrahedra_sharing_edge();
  const PassRun kept = run_pass(soup, split_edges_and_walls, body_limits(soup, {0, 3}));
  EXPECT_TRUE(same_soup(kept.tracked.soup, soup));
  ASSERT_EQ(kept.refused.size(), 1U);
  EXPECT_EQ(kept.refused[0].code, DefectCode::NonManifold);
  EXPECT_EQ(kept.refused[0].vertex, 0U);

  const PassRun cut = run_pass(soup, split_edges_and_walls, body_limits(soup, {0}));
  EXPECT_EQ(cut.tracked.soup.n_vertices(), soup.n_vertices() + 1);
  EXPECT_EQ(build(cut.tracked.soup).side.non_manifold_edges.size(), 0U);
}

TEST(SplitEdges, VertexOfVeryManyFansGetsNoCopies) {
  // Edges with three faces each, two of which stay joined: two fans for each.
  const auto edges_round_a_vertex = [](Index n) {
    std::vector<Triangle> faces;
    for (Index a = 1; a < 4 * n; a += 4) {
      for (const Index b : {a + 1, a + 2, a + 3}) faces.push_back({0, a, b});
    }
    return soup_of(1 + 4 * n, faces);
  };
  for (const Index n : {250, 251}) {
    const Soup soup = edges_round_a_vertex(n);
    const Soup cut = run_pass(soup, split_edges_and_walls).tracked.soup;
    EXPECT_EQ(build(cut).side.non_manifold_edges.size(), 0U);
    const auto n_at_vertex = std::count_if(cut.triangles.begin(), cut.triangles.end(),
                                           [](const Triangle& t) { return t[0] == 0; });
    EXPECT_EQ(n_at_vertex == static_cast<std::ptrdiff_t>(cut.n_faces()), n == 251);
  }
}

TEST(SplitEdges, EdgeWithVeryManyFansAtBothEndsIsRefused) {
  // As all faces go the same way round, no two stay joined.
  EXPECT_TRUE(run_pass(faces_round_edge(500), split_edges_and_walls).refused.empty());
  const Soup soup = faces_round_edge(501);
  const PassRun run = run_pass(soup, split_edges_and_walls);
  EXPECT_TRUE(same_soup(run.tracked.soup, soup));
  EXPECT_EQ(run.refused.size(), 1U);
}

TEST(SplitEdges, AnySoupIsManifoldAtItsEdgesAtOnce) {
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    Soup soup;
    for (int i = 0; i < 12; ++i) {
      soup.positions.emplace_back(below(random, 4), below(random, 4), below(random, 4));
    }
    for (std::uint32_t i = 0; i < 5 + seed % 60; ++i) {
      soup.triangles.push_back({below(random, 12), below(random, 12), below(random, 12)});
    }
    const PassRun run = run_pass(soup, split_edges_and_walls);
    EXPECT_LE(run.rounds, 1U);
    EXPECT_TRUE(is_cut_version(run.tracked.soup, soup));
    EXPECT_EQ(build(run.tracked.soup).side.non_manifold_edges.size(), 0U);
  }
}

}  // namespace
}  // namespace meshalyzer
