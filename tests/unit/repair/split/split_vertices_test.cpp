#include "meshalyzer/repair/passes.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"
#include "support/soups.h"
#include "unit/repair/split/split_passes.h"
#include "unit/repair/voxel_solid.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace meshalyzer {
namespace {

TEST(SplitVertices, MeshesWithoutAPinchAreLeft) {
  const std::array<Index, 1> face{4};
  for (const Soup& soup : {shapes::cube(), shapes::moebius_strip(5), Soup{}, shapes::open_cube(),
                           shapes::flipped(shapes::cube(), face)}) {
    EXPECT_TRUE(same_soup(run_pass(soup, split_vertices).tracked.soup, soup));
  }
}

TEST(SplitVertices, TetrahedraWithACommonVertexComeApart) {
  const Soup soup = shapes::two_tetrahedra_sharing_vertex();
  const PassRun run = run_pass(soup, split_vertices);
  EXPECT_EQ(run.operations, 1U);
  EXPECT_EQ(run.rounds, 1U);
  EXPECT_TRUE(is_cut_version(run.tracked.soup, soup));
  EXPECT_TRUE(is_manifold(run.tracked.soup));
  EXPECT_EQ(volumes(run.tracked.soup), (std::vector<double>{1.0 / 6, 1.0 / 6}));
  EXPECT_EQ(run.tracked.soup.n_vertices(), soup.n_vertices() + 1);
}

TEST(SplitVertices, EndsOfNonManifoldEdgesAreNotItsMatter) {
  EXPECT_EQ(run_pass(shapes::two_tetrahedra_sharing_edge(), split_vertices).operations, 0U);
}

TEST(SplitVertices, EachFanGetsAVertex) {
  // Four faces that have but a vertex in common.
  const Soup soup = soup_of(9, {{0, 1, 2}, {0, 3, 4}, {5, 0, 6}, {7, 8, 0}});
  const PassRun run = run_pass(soup, split_vertices);
  EXPECT_EQ(n_components(run.tracked.soup), 4U);
  EXPECT_EQ(run.tracked.soup.triangles[0], soup.triangles[0]);
}

TEST(SplitVertices, VertexOfVeryManyFansIsRefused) {
  const auto fans = [](Index n) {
    std::vector<Triangle> faces;
    for (Index i = 0; i < n; ++i) faces.push_back({0, 1 + 2 * i, 2 + 2 * i});
    return soup_of(1 + 2 * n, faces);
  };
  EXPECT_EQ(n_components(run_pass(fans(500), split_vertices).tracked.soup), 500U);
  const Soup soup = fans(501);
  const PassRun run = run_pass(soup, split_vertices);
  EXPECT_TRUE(same_soup(run.tracked.soup, soup));
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(run.refused[0].vertex, 0U);
}

TEST(SplitVertices, PinchesAtBothEndsOfAnEdgeAreOneOperation) {
  // The last face has but a vertex in common with each of the others, and changes at both.
  const Soup soup = soup_of(7, {{0, 2, 3}, {1, 5, 6}, {0, 1, 4}});
  const PassRun run = run_pass(soup, split_vertices);
  EXPECT_EQ(run.operations, 1U);
  EXPECT_EQ(n_components(run.tracked.soup), 3U);
}

TEST(SplitVertices, FixedVertexOfABodyIsRefused) {
  const Soup soup = shapes::two_tetrahedra_sharing_vertex();
  const PassRun run = run_pass(soup, split_vertices, body_limits(soup, {0}));
  EXPECT_TRUE(same_soup(run.tracked.soup, soup));
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(run.refused[0].vertex, 0U);
}

TEST(SplitVertices, FixedVertexThatIsOnNoBodyIsSplitWhereItStands) {
  const Soup soup = shapes::two_tetrahedra_sharing_vertex();
  RepairLimits limits = body_limits(soup, {0});
  limits.groups = Groups::Names;
  EXPECT_EQ(run_pass(soup, split_vertices, limits).operations, 1U);
}

}  // namespace
}  // namespace meshalyzer
