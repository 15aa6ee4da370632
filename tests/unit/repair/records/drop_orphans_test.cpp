#include "meshalyzer/repair/passes.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace meshalyzer {
namespace {

TEST(DropOrphans, MeshWithoutOrphansIsLeft) {
  EXPECT_TRUE(same_soup(run_pass(shapes::cube(), drop_orphans).tracked.soup, shapes::cube()));
}

TEST(DropOrphans, UnusedVerticesGoAndTheOthersKeepTheirIds) {
  Soup soup = shapes::tetrahedron();
  soup.positions.insert(soup.positions.begin(), Vec3(5, 5, 5));
  soup.positions.emplace_back(6, 6, 6);
  for (Triangle& t : soup.triangles) {
    for (Index& v : t) ++v;
  }
  const PassRun run = run_pass(soup, drop_orphans);
  EXPECT_EQ(run.operations, 1U);
  EXPECT_EQ(run.tracked.soup.positions, shapes::tetrahedron().positions);
  EXPECT_EQ(run.tracked.soup.triangles, shapes::tetrahedron().triangles);
  EXPECT_EQ(run.tracked.soup.vertex_ids.of(0), 2);
}

TEST(DropOrphans, VertexOfABrokenFaceIsNoOrphan) {
  Soup soup = shapes::tetrahedron();
  soup.positions.emplace_back(6, 6, 6);
  soup.triangles.push_back({4, 4, 4});
  EXPECT_TRUE(same_soup(run_pass(soup, drop_orphans).tracked.soup, soup));
}

TEST(DropOrphans, RepeatedRecordIsForOthers) {
  Soup soup = shapes::tetrahedron();
  soup.positions.emplace_back(6, 6, 6);
  soup.vertex_ids.named = {1, 2, 3, 4, 4};
  EXPECT_TRUE(same_soup(run_pass(soup, drop_orphans).tracked.soup, soup));
}

TEST(DropOrphans, FixedVertexStays) {
  Soup soup = shapes::tetrahedron();
  soup.positions.emplace_back(6, 6, 6);
  RepairLimits limits = wide_limits(soup);
  limits.fixed_vertices = {0, 0, 0, 0, 1};
  const PassRun run = run_pass(soup, drop_orphans, limits);
  EXPECT_TRUE(same_soup(run.tracked.soup, soup));
  EXPECT_EQ(run.refused.size(), 1U);
}

}  // namespace
}  // namespace meshalyzer
