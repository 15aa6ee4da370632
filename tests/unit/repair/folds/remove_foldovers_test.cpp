#include "meshalyzer/defects/finders.h"
#include "meshalyzer/geometry/edge_measures.h"
#include "meshalyzer/repair/fix_defects.h"
#include "meshalyzer/repair/passes.h"
#include "support/foldovers.h"
#include "support/random_soups.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

using shapes::grid_vertex;

/// Limits within which a vertex may move so far.
RepairLimits limits_of(double max_deviation) {
  return {.max_deviation = max_deviation, .fixed_vertices = {}, .groups = Groups::Names};
}

/// The fixed vertices are these.
RepairLimits limits_with_fixed(double max_deviation, const std::vector<Index>& fixed) {
  RepairLimits limits = limits_of(max_deviation);
  for (const Index v : fixed) {
    if (limits.fixed_vertices.size() <= v) limits.fixed_vertices.resize(v + std::size_t{1}, 0);
    limits.fixed_vertices[v] = 1;
  }
  return limits;
}

/// Expects that nothing in a mesh is folded, meets anything, or is cut.
void expect_unfolded(const PreparedMesh& mesh) {
  EXPECT_TRUE(mesh.intersecting_pairs().empty());
  EXPECT_TRUE(find_foldovers(mesh, {.height = 1e-6, .max_foldover_angle = 1.0}).empty());
  EXPECT_EQ(mesh.cut().side.non_manifold_edges.size(), 0U);
  EXPECT_EQ(mesh.cut().side.flipped_edges.size(), 0U);
  EXPECT_TRUE(mesh.cut().side.non_manifold_vertices.empty());
}

/// Expects that a mesh is flat besides.
void expect_clean(const Soup& soup) {
  const PreparedMesh mesh(soup);
  expect_unfolded(mesh);
  for (const double angle : measure_edge_angles(mesh.cut().mesh, {}).degrees) {
    EXPECT_NEAR(angle, 180.0, 1e-6);
  }
}

TEST(RemoveFoldovers, FlatSheetStaysAsItIs) {
  const Soup soup = shapes::grid(5, 4);
  const PassRun run = run_pass(soup, remove_foldovers);
  EXPECT_EQ(run.operations, 0U);
  EXPECT_TRUE(run.refused.empty());
  EXPECT_TRUE(same_soup(run.tracked.soup, soup));
}

TEST(RemoveFoldovers, DraggedVertexIsMovedBackAndNothingElseChanges) {
  const Soup soup = shapes::dragged_vertex();
  const PassRun run = run_pass(soup, remove_foldovers, limits_of(2.0));
  EXPECT_EQ(run.operations, 1U);
  expect_clean(run.tracked.soup);
  EXPECT_EQ(run.tracked.soup.triangles, soup.triangles);
  for (Index v = 0; v < soup.n_vertices(); ++v) {
    if (v == grid_vertex(5, 2, 2)) continue;
    EXPECT_EQ(run.tracked.soup.positions[v], soup.positions[v]);
  }
  EXPECT_TRUE(same_soup(run_pass(run.tracked.soup, remove_foldovers, limits_of(2.0)).tracked.soup,
                        run.tracked.soup));
}

TEST(RemoveFoldovers, VertexThatMayNotMoveSoFarIsTakenAway) {
  // It is 0.1 beyond the edge of its ring, but in the plane of the rest.
  const Soup soup = shapes::dragged_vertex();
  const PassRun run = run_pass(soup, remove_foldovers, limits_of(0.01));
  EXPECT_EQ(run.operations, 1U);
  expect_clean(run.tracked.soup);
  // Six faces at it, a hexagon of four without it.
  EXPECT_EQ(run.tracked.soup.n_faces(), soup.n_faces() - 2);
  EXPECT_EQ(run.tracked.soup.n_vertices(), soup.n_vertices() - 1);
  // The outline of the sheet is what it was: no hole is left.
  EXPECT_EQ(find_holes(PreparedMesh(run.tracked.soup), {}).size(), 1U);
  EXPECT_EQ(*find_holes(PreparedMesh(run.tracked.soup), {})[0].value, 18.0);
}

TEST(RemoveFoldovers, NoVertexMovesFartherThanTheDeviation) {
  for (const double deviation : {0.05, 0.2, 0.3, 0.5, 1.0}) {
    const Soup soup = shapes::dragged_vertex();
    const PassRun run = run_pass(soup, remove_foldovers, limits_of(deviation));
    expect_clean(run.tracked.soup);
    for (Index v = 0; v < run.tracked.soup.n_vertices(); ++v) {
      const Vec3& before = soup.positions[run.tracked.vertex_keys[v]];
      EXPECT_LE((run.tracked.soup.positions[v] - before).norm(), deviation);
    }
  }
}

TEST(RemoveFoldovers, FixedVerticesStay) {
  const Soup soup = shapes::dragged_vertex();
  std::vector<Index> all;
  for (Index v = 0; v < soup.n_vertices(); ++v) all.push_back(v);
  const PassRun run = run_pass(soup, remove_foldovers, limits_with_fixed(2.0, all));
  EXPECT_EQ(run.operations, 0U);
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(run.refused[0].code, DefectCode::Foldover);
  EXPECT_NE(run.refused[0].face, kNoIndex);
  EXPECT_FALSE(run.refused[0].reason.empty());
  EXPECT_TRUE(same_soup(run.tracked.soup, soup));
}

TEST(RemoveFoldovers, GroupBordersKeepTheirVertices) {
  // The dragged vertex is where the second half of the faces begins to be another group.
  Soup soup = shapes::dragged_vertex();
  soup.groups = {{"low", 0}, {"high", 20}};
  RepairLimits limits = limits_of(2.0);
  limits.groups = Groups::Faces;
  const PassRun run = run_pass(soup, remove_foldovers, limits);
  for (Index v = 0; v < run.tracked.soup.n_vertices(); ++v) {
    if (run.tracked.vertex_keys[v] != grid_vertex(5, 2, 2)) continue;
    EXPECT_EQ(run.tracked.soup.positions[v], soup.positions[grid_vertex(5, 2, 2)]);
    return;
  }
  ADD_FAILURE() << "the vertex is gone";
}

TEST(RemoveFoldovers, RandomlyDraggedVertexIsMended) {
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i) {
    Soup soup = shapes::grid(6, 6);
    const auto somewhere = [&] { return 0.5 + below(random, 5001) * 0.001 + 1e-5; };
    soup.positions[grid_vertex(6, 3, 3)] = {somewhere(), somewhere() + 0.00037, 0.0};
    SCOPED_TRACE(i);
    const RepairLimits limits = limits_of(i % 2 == 0 ? 10.0 : 1e-3);
    const PassRun run = run_pass(soup, remove_foldovers, limits);
    SCOPED_TRACE(::testing::PrintToString(soup.positions[grid_vertex(6, 3, 3)].transpose()));
    EXPECT_TRUE(run.refused.empty()) << run.refused[0].reason;
    EXPECT_LE(run.operations, 1U);
    expect_clean(run.tracked.soup);
  }
}

TEST(RemoveFoldovers, ManyFoldoversAreAllMended) {
  // A vertex of every third row and column dragged over an edge.
  Soup soup = shapes::grid(31, 31);
  for (std::size_t y = 2; y < 30; y += 3) {
    for (std::size_t x = 2; x < 29; x += 3) {
      soup.positions[grid_vertex(31, x, y)] += Vec3(1.1, 0.5, 0.0);
    }
  }
  const PassRun run = run_pass(soup, remove_foldovers, limits_of(2.0));
  EXPECT_EQ(run.operations, 90U);
  expect_clean(run.tracked.soup);
}

TEST(RemoveFoldovers, FoldedCornerIsCutOff) {
  const Soup soup = shapes::dog_ear();
  const PassRun run = run_pass(soup, remove_foldovers);
  EXPECT_EQ(run.operations, 1U);
  EXPECT_EQ(run.tracked.soup.n_faces(), soup.n_faces() - 1);
  EXPECT_EQ(run.tracked.soup.n_vertices(), soup.n_vertices() - 1);
  expect_clean(run.tracked.soup);
}

TEST(RemoveFoldovers, FoldedCornerThatMustStayIsRefused) {
  const Soup soup = shapes::dog_ear();
  const PassRun run =
      run_pass(soup, remove_foldovers, limits_with_fixed(2.0, {grid_vertex(5, 5, 0)}));
  EXPECT_EQ(run.operations, 0U);
  EXPECT_EQ(run.refused.size(), 1U);
}

TEST(RemoveFoldovers, FoldedEndOfAStripIsCutOff) {
  const Soup soup = shapes::folded_strip(7, std::array{5.0});
  const PassRun run = run_pass(soup, remove_foldovers);
  // 2 x 2 squares of 7 x 2.
  EXPECT_EQ(run.tracked.soup.n_faces(), 20U);
  expect_clean(run.tracked.soup);
}

TEST(RemoveFoldovers, MiddleSheetFromBorderToBorderIsRefused) {
  const Soup soup = shapes::folded_strip(12, std::array{6.0, 8.0});
  const PassRun run = run_pass(soup, remove_foldovers);
  EXPECT_EQ(run.operations, 0U);
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_TRUE(same_soup(run.tracked.soup, soup));
}

TEST(RemoveFoldovers, PleatOfSeveralVerticesIsMended) {
  // Three vertices of a row dragged over the next one: a region of several faces.
  Soup soup = shapes::grid(8, 8);
  for (std::size_t x = 3; x <= 5; ++x) soup.positions[grid_vertex(8, x, 3)] += Vec3(0.05, 1.2, 0.0);
  const DefectList before =
      find_foldovers(PreparedMesh(soup), {.height = 1e-6, .max_foldover_angle = 1.0});
  ASSERT_EQ(before.size(), 1U);
  EXPECT_GT(before[0].faces.size(), 3U);
  for (const double deviation : {5.0, 0.001}) {
    const PassRun run = run_pass(soup, remove_foldovers, limits_of(deviation));
    EXPECT_TRUE(run.refused.empty());
    expect_clean(run.tracked.soup);
    EXPECT_EQ(*find_holes(PreparedMesh(run.tracked.soup), {})[0].value, 32.0);
  }
}

/// A pyramid on whose base a flap lies: three layers of two faces, nanometres apart. The one in the
/// middle is a foldover: its edges with the flap's outside run through vertex 4, which is over
/// vertex 2 of the base; those with the base through vertex 6, which is under vertex 5 of the flap.
Soup pyramid_with_flap() {
  return shapes::make({{0, -1, 0},
                       {0, 1, 0},
                       {0, 0, 1},
                       {-2, 0, 0},
                       {2e-9, 0, 1},
                       {4e-9, 0, -1},
                       {0, 0, -1 + 1e-8}},
                      {{5, 0, 3},
                       {1, 5, 3},
                       {2, 1, 3},
                       {0, 2, 3},
                       {0, 5, 4},
                       {5, 1, 4},
                       {0, 4, 6},
                       {6, 4, 1},
                       {0, 6, 2},
                       {6, 1, 2}});
}

/// Expects the flap to be gone, but for one layer.
void expect_no_flap(const Soup& soup) {
  EXPECT_EQ(soup.n_vertices(), 5U);
  EXPECT_EQ(soup.n_faces(), 6U);
  const PreparedMesh mesh(soup);
  expect_unfolded(mesh);
  for (const auto h : mesh.cut().mesh.halfedges()) EXPECT_FALSE(mesh.cut().mesh.is_boundary(h));
}

TEST(RemoveFoldovers, LayersWithTheSameCornersAreJoined) {
  const Soup soup = pyramid_with_flap();
  const PreparedMesh mesh(soup);
  ASSERT_TRUE(mesh.intersecting_pairs().empty());
  ASSERT_EQ(find_foldovers(mesh, {.height = 1e-6, .max_foldover_angle = 1.0}).size(), 1U);
  const RepairResult result = fix_defects(soup);
  expect_no_flap(result.meshes.front().tracked.soup);
  EXPECT_LE(result.deviation, 2e-8);
}

TEST(RemoveFoldovers, LayersAreJoinedAtVerticesThatMayMove) {
  const Soup soup = pyramid_with_flap();
  EXPECT_EQ(run_pass(soup, remove_foldovers, limits_with_fixed(0.001, {2, 4, 5, 6})).operations,
            0U);
  for (const std::vector<Index>& fixed : {std::vector<Index>{4, 5, 6}, {2, 5, 6}, {2, 4, 6}}) {
    const PassRun run = run_pass(soup, remove_foldovers, limits_with_fixed(0.001, fixed));
    expect_no_flap(run.tracked.soup);
  }
}

TEST(RemoveFoldovers, LayersOfTwoGroupsAreNotJoinedIfGroupsKeepTheirBorders) {
  Soup soup = pyramid_with_flap();
  soup.groups = {{"outside", 0}, {"middle", 6}, {"base", 8}};
  RepairLimits limits = limits_of(0.001);
  EXPECT_EQ(run_pass(soup, remove_foldovers, limits).operations, 1U);
  limits.groups = Groups::Faces;
  EXPECT_EQ(run_pass(soup, remove_foldovers, limits).operations, 0U);
}

TEST(RemoveFoldovers, LayersFartherApartThanTheToleranceStay) {
  Soup soup = pyramid_with_flap();
  for (const Index v : {4U, 5U}) soup.positions[v].z() *= 1.001;
  EXPECT_EQ(run_pass(soup, remove_foldovers, limits_of(1e-4)).operations, 0U);
}

TEST(RemoveFoldovers, SurvivesBadMeshes) {
  for (const double factor : {1e-320, 1e-160, 1e160, 1e307}) {
    (void)run_pass(shapes::scaled(shapes::dragged_vertex(), factor), remove_foldovers);
  }
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    Soup soup = damaged(shapes::grid(6, 6), 6, random);
    for (Vec3& p : soup.positions) p += Vec3(below(random, 3), below(random, 3), 0) / 2;
    (void)run_pass(soup, remove_foldovers);
  }
}

}  // namespace
}  // namespace meshalyzer
