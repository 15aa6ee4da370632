#include "meshalyzer/repair/holes/internal/smooth_patch.h"

#include "meshalyzer/repair/holes/internal/triangulate_large_loop.h"
#include "support/punched_holes.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace meshalyzer {
namespace {

TEST(SmoothPatch, HasAboutTheNumberOfNewVerticesAllowedAndAtMostTwiceAsMany) {
  const test::PunchedMesh punched = test::punch(shapes::icosphere(4), 0, 0.6);
  const PreparedMesh mesh(punched.open);
  const HoleLoops found = find_hole_loops(mesh);
  ASSERT_EQ(found.loops.size(), 1U);
  const HoleLoop& loop = found.loops.front();
  const ExistingEdges existing(mesh, found.loops);
  const FillTask task{.mesh = mesh, .existing = existing};
  const auto triangles = triangulate_large_loop(make_polygon(mesh, loop, task.degeneracy),
                                                LoopRules{.existing = &existing});
  ASSERT_TRUE(triangles.has_value());
  const Patch flat{.triangles = *triangles, .added = {}};

  // By Euler's formula: the lost surface is a disk.
  const std::size_t n_lost = (punched.lost.n_faces() + 2 - loop.size()) / 2;
  const auto fine = smooth_patch(task, loop, flat, 1'000);
  ASSERT_TRUE(fine.has_value());
  EXPECT_GT(fine->added.size(), n_lost / 2);
  EXPECT_LT(fine->added.size(), 2 * n_lost);
  const auto coarse = smooth_patch(task, loop, flat, 10);
  ASSERT_TRUE(coarse.has_value());
  EXPECT_GE(coarse->added.size(), 5U);
  EXPECT_LE(coarse->added.size(), 20U);
}

}  // namespace
}  // namespace meshalyzer
