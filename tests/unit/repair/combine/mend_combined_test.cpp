#include "meshalyzer/repair/combine/mend_combined.h"

#include "meshalyzer/defects/check.h"
#include "meshalyzer/repair/combine/track_combined.h"
#include "support/random_soups.h"
#include "support/shapes.h"
#include "unit/repair/combine/combination.h"
#include "unit/repair/repaired_meshes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

const CombineOptions kOptions{.max_deviation = 1e-3};

MendedMesh mend(const Combination& made) {
  return mend_combined(track_combined(made.all, made.solid), made.solid.outcome, false, kOptions);
}

TEST(MendCombined, CubesThatShareAnEdgeArePartedAndTrackedToTheInput) {
  const MendedMesh parted = mend({shapes::cube(), shapes::cube(1, {1, 1, 0}), union_rule()});
  EXPECT_TRUE(parted.is_parted);
  EXPECT_FALSE(parted.is_repaired);
  EXPECT_GT(parted.largest_move, 0.0);
  EXPECT_LT(parted.largest_move, 1e-14);
  EXPECT_EQ(parted.mesh.soup.n_vertices(), 16U);
  EXPECT_EQ(parted.mesh.n_input_faces, 24U);
  std::set<Index> origins;
  for (Index f = 0; f < 24; ++f) origins.insert(parted.mesh.origin_of_face(f));
  EXPECT_EQ(origins.size(), 24U);
  EXPECT_EQ(*origins.rbegin(), 23U);
}

TEST(MendCombined, SliversStayOutward) {
  // Tetrahedra at a corner of a cube that are flat but for rounding: another rounding may turn them
  // inside out.
  std::mt19937 random(3);
  const auto share = [&] { return (1.0 + below(random, 1000)) / 1001.0; };
  std::size_t n_parted = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 corner(1, 1, 1);
    const Vec3 a = corner + Vec3(share(), share(), share());
    const Vec3 b = corner + Vec3(share(), share(), share());
    const Vec3 between = corner + share() * (a - corner) + share() * (b - corner);
    const Soup sliver =
        shapes::make({corner, a, b, between}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
    if (!is_good(sliver)) continue;
    const MendedMesh parted = mend({shapes::cube(), sliver, union_rule()});
    n_parted += parted.is_mended() ? 1 : 0;
    EXPECT_TRUE(is_good(parted.mesh.soup)) << trial;
  }
  EXPECT_GT(n_parted, 50U);
}

TEST(MendCombined, PartThatIsInsideOutIsOrientedOutwards) {
  const Soup inside_out = shapes::flipped(shapes::translated(shapes::tetrahedron(), {5, 0, 0}));
  const MendedMesh parted = mend_combined(track_mesh(shapes::merged(shapes::cube(), inside_out)),
                                          CombineOutcome::Done, false, kOptions);
  EXPECT_TRUE(parted.is_oriented);
  EXPECT_EQ(parted.largest_move, 0.0);
  EXPECT_TRUE(is_good(parted.mesh.soup));
}

TEST(MendCombined, ManifoldMeshStays) {
  const Combination cut(shapes::cube(2), shapes::cube(2, {1, 1, 1}));
  const MendedMesh same = mend(cut);
  EXPECT_FALSE(same.is_mended());
  EXPECT_EQ(same.mesh.soup.positions, track_combined(cut.all, cut.solid).soup.positions);
}

TEST(MendCombined, MeshThatWasMovedIsRepairedWhereItIntersectsItself) {
  const Soup cubes = shapes::merged(shapes::cube(2), shapes::cube(2, {1, 1, 1}));
  const MendedMesh moved = mend_combined(track_mesh(cubes), CombineOutcome::Done, true, kOptions);
  EXPECT_TRUE(moved.is_repaired);
  EXPECT_TRUE(is_good(moved.mesh.soup));
  const Soup apart = shapes::merged(shapes::cube(), shapes::cube(1, {5, 0, 0}));
  EXPECT_FALSE(mend_combined(track_mesh(apart), CombineOutcome::Done, true, kOptions).is_mended());
}

TEST(MendCombined, FacesThatStillIntersectAreCutAndTrackedToTheInput) {
  const Soup cubes = shapes::merged(shapes::cube(2), shapes::cube(2, {1, 1, 1}));
  const MendedMesh mended =
      mend_combined(track_mesh(cubes), CombineOutcome::Unfinished, false, kOptions);
  EXPECT_TRUE(mended.is_repaired);
  EXPECT_LE(mended.largest_move, 1e-3);
  EXPECT_TRUE(is_good(mended.mesh.soup));
  // 8 + 8 - 1
  EXPECT_NEAR(volume_of(mended.mesh.soup), 15.0, 1e-12);
  for (Index f = 0; f < mended.mesh.soup.n_faces(); ++f) {
    EXPECT_LT(mended.mesh.origin_of_face(f), 24U);
  }
}

/// Spheres that differ by rounding alone.
std::vector<Soup> equal_spheres() {
  std::mt19937 random(7);
  std::vector<Soup> spheres(6, shapes::icosphere(2));
  for (Soup& sphere : spheres) {
    for (Vec3& p : sphere.positions) {
      for (double& x : p) x *= 1.0 + 2e-16 * (below(random, 3) - 1.0);
    }
  }
  return spheres;
}

TEST(MendCombined, WhatRoundingMakesIntersectAgainAndAgain) {
  // No vertex may be moved to a grid. Each round of cutting makes other faces intersect, at first a
  // few and then thousands.
  const std::vector<Soup> spheres = equal_spheres();
  const Soup all = concatenate(spheres);
  const CombinedSolid solid = combine_solids(operands_of(all, spheres), union_rule());
  EXPECT_EQ(solid.outcome, CombineOutcome::Unfinished);
  EXPECT_LT(PreparedMesh(as_soup(solid)).intersecting_pairs().size(), 100U);
  const TrackedMesh combined = track_combined(all, solid);
  const MendedMesh mended = mend_combined(combined, solid.outcome, false, kOptions);
  EXPECT_TRUE(is_good(mended.mesh.soup));
}

TEST(CombineSolids, MovesFacesThatDifferByRoundingToAGrid) {
  const std::vector<Soup> spheres = equal_spheres();
  const Soup all = concatenate(spheres);
  const CombinedSolid solid =
      combine_solids(operands_of(all, spheres), union_rule(), {.max_deviation = 1e-3});
  EXPECT_EQ(solid.outcome, CombineOutcome::Done);
  EXPECT_LT(solid.largest_move, 1e-11);
  EXPECT_TRUE(is_good(as_soup(solid)));
  EXPECT_NEAR(volume_of(as_soup(solid)), volume_of(spheres.front()), 1e-10);
}

TEST(MendCombined, StopsWhenItIsTold) {
  const Soup cubes = shapes::merged(shapes::cube(2), shapes::cube(2, {1, 1, 1}));
  const MendedMesh mended =
      mend_combined(track_mesh(cubes), CombineOutcome::Unfinished, false,
                    {.max_deviation = 1e-3, .wants_to_stop = [] { return true; }});
  EXPECT_EQ(mended.mesh.soup.triangles, cubes.triangles);
}

TEST(KeepOff, MeshThatWasMovedIntoAnotherLosesWhatThatHas) {
  const Soup cube = shapes::cube(2);
  const Soup other = shapes::cube(1, {1.5, 1.25, 1.75});
  const MendedMesh apart =
      keep_off({.mesh = track_mesh(cube), .is_repaired = true, .largest_move = 1e-9}, other,
               {.max_deviation = 1e-3});
  const Soup& left = apart.mesh.soup;
  EXPECT_NEAR(volume_of(left), 8.0 - 0.5 * 0.75 * 0.25, 1e-9);
  EXPECT_TRUE(check_pair(left, other).empty());
  EXPECT_TRUE(apart.is_subtracted_again);
  EXPECT_GT(apart.largest_move, 1e-9);
  // The six faces of the sides that the other mesh does not touch are as they were, and so is the
  // one of the others that does not have the corner which was cut off.
  std::size_t n_whole = 0;
  for (Index f = 0; f < left.n_faces(); ++f) {
    const Index key = apart.mesh.face_keys[f];
    if (key >= cube.n_faces()) continue;
    ++n_whole;
    EXPECT_EQ(corners_of(left, f), corners_of(cube, key));
  }
  EXPECT_EQ(n_whole, 7U);
}

TEST(KeepOff, MeshStaysWhereItWouldMoveTooFar) {
  // Spheres that intersect: their union has rounded vertices, so no distance at all is too little.
  const Soup sphere = shapes::icosphere(1);
  const Soup spheres = shapes::merged(sphere, shapes::translated(sphere, {0.3, 0.2, 0.1}));
  const Soup other = shapes::cube(1, {3, 3, 3});
  const MendedMesh same =
      keep_off({.mesh = track_mesh(spheres), .is_repaired = true, .largest_move = 0.0}, other,
               {.max_deviation = 0.0});
  EXPECT_EQ(same.mesh.soup.triangles, spheres.triangles);
  const MendedMesh cut =
      keep_off({.mesh = track_mesh(spheres), .is_repaired = true, .largest_move = 0.0}, other,
               {.max_deviation = 1e-3});
  EXPECT_TRUE(is_good(cut.mesh.soup));
  EXPECT_LE(cut.largest_move, 1e-3);
}

TEST(KeepOff, MeshThatMeetsNoOtherStays) {
  const Soup cube = shapes::cube(2);
  const MendedMesh same =
      keep_off({.mesh = track_mesh(cube), .is_repaired = true, .largest_move = 0.0},
               shapes::cube(1, {3, 3, 3}), {});
  EXPECT_EQ(same.mesh.soup.positions, cube.positions);
  EXPECT_EQ(same.mesh.soup.triangles, cube.triangles);
}

}  // namespace
}  // namespace meshalyzer
