#include "meshalyzer/repair/combine/track_combined.h"

#include "meshalyzer/defects/check.h"
#include "support/random_soups.h"
#include "support/shapes.h"
#include "unit/repair/repaired_meshes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

/// Two meshes, and what an operation makes of them: the first one without the second if nothing
/// else is said.
struct Combination {
  Combination(const Soup& a, const Soup& b, const InsideRule& rule = difference_rule())
      : meshes{a, b},
        all(concatenate(meshes)),
        solid(combine_solids(operands_of(all, meshes), rule)) {}

  std::vector<Soup> meshes;
  Soup all;
  CombinedSolid solid;
};

TEST(TrackCombined, FaceThatStaysIsThatOfTheInput) {
  const Combination cut(shapes::cube(3), shapes::cube(1, {1, 1, 1}));
  const TrackedMesh tracked = track_combined(cut.all, cut.solid);
  ASSERT_EQ(tracked.soup.n_faces(), 24U);
  for (Index f = 0; f < 24; ++f) EXPECT_EQ(tracked.face_keys[f], f);
  // The wall of the cavity is the second cube, turned over.
  EXPECT_EQ(tracked.soup.triangles[12][1], cut.all.triangles[12][2]);
}

TEST(TrackCombined, WallsCountAsPatchesWhereTheFirstMeshAloneIsEdited) {
  const Combination cut(shapes::cube(3), shapes::cube(1, {1, 1, 1}));
  const TrackedMesh tracked = track_combined(cut.meshes.front(), cut.solid);
  ASSERT_EQ(tracked.soup.n_faces(), 24U);
  EXPECT_EQ(tracked.n_input_faces, 12U);
  for (Index f = 0; f < 24; ++f) {
    EXPECT_EQ(tracked.origin_of_face(f), f < 12 ? f : kNoIndex);
  }
}

TEST(TrackCombined, PartOfAFaceIsMadeOfIt) {
  const Combination cut(shapes::cube(2), shapes::cube(2, {1, 1, 1}));
  const TrackedMesh tracked = track_combined(cut.all, cut.solid);
  for (Index f = 0; f < tracked.soup.n_faces(); ++f) {
    EXPECT_LT(tracked.origin_of_face(f), cut.all.n_faces());
  }
  // The ids are 1, 2, ..., n.
  EXPECT_TRUE(tracked.soup.vertex_ids.named.empty());
  EXPECT_EQ(tracked.soup.vertex_ids.first, 1);
}

TEST(TrackCombined, NormalsOfWhatIsTurnedOverAreTurned) {
  Soup hole = shapes::cube(1, {1, 1, 1});
  for (const Vec3& p : hole.positions) hole.normals.push_back(p - Vec3(1.5, 1.5, 1.5));
  hole.corner_normals = hole.triangles;
  const Combination cut(shapes::cube(3), hole);
  const TrackedMesh tracked = track_combined(cut.all, cut.solid);
  for (Index f = 12; f < 24; ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& at = tracked.soup.positions[tracked.soup.triangles[f][k]];
      const Index normal = tracked.soup.corner_normals[f][k];
      EXPECT_LT(tracked.soup.normals[normal].dot(at - Vec3(1.5, 1.5, 1.5)), 0.0);
    }
  }
}

Vec3 unit_normal(const Soup& soup, Index f) {
  const auto [a, b, c] = corners_of(soup, f);
  return (b - a).cross(c - a).normalized();
}

/// Gives each face of a mesh its own normal at its three corners.
Soup flat_shaded(Soup soup) {
  soup.format = Format::Obj;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    soup.normals.push_back(unit_normal(soup, f));
    soup.corner_normals.push_back({f, f, f});
  }
  return soup;
}

void expect_flat_shaded(const Soup& soup) {
  ASSERT_EQ(soup.corner_normals.size(), soup.n_faces());
  for (Index f = 0; f < soup.n_faces(); ++f) {
    for (const Index normal : soup.corner_normals[f]) {
      ASSERT_NE(normal, kNoIndex);
      EXPECT_GT(soup.normals[normal].dot(unit_normal(soup, f)), 1 - 1e-12);
    }
  }
}

TEST(TrackCombined, FlatShadingStaysWhereSolidsAreCutTurnedOrMerged) {
  const Soup cube = flat_shaded(shapes::cube(2));
  for (const Vec3& at : {Vec3(1, 1, 1), Vec3(2, 0, 0), Vec3(0.5, 0.5, 1.5)}) {
    const Combination cut(cube, flat_shaded(shapes::cube(1.25, at)));
    expect_flat_shaded(track_combined(cut.all, cut.solid).soup);
  }
  const Combination united(cube, flat_shaded(shapes::cube(2, {2, 0, 0})), union_rule());
  expect_flat_shaded(track_combined(united.all, united.solid).soup);
}

TEST(IsUnchanged, OnlyWhereEveryFaceStays) {
  const Combination apart(shapes::cube(), shapes::cube(1, {5, 0, 0}));
  EXPECT_TRUE(is_unchanged(apart.meshes.front(), apart.solid));
  EXPECT_FALSE(is_unchanged(apart.all, apart.solid));
  const Combination cut(shapes::cube(2), shapes::cube(2, {1, 1, 1}));
  EXPECT_FALSE(is_unchanged(cut.meshes.front(), cut.solid));
}

TEST(PartCombined, CubesThatShareAnEdgeArePartedAndTrackedToTheInput) {
  const std::vector<Soup> meshes{shapes::cube(), shapes::cube(1, {1, 1, 0})};
  const Soup all = concatenate(meshes);
  const CombinedSolid solid = combine_solids(operands_of(all, meshes), union_rule());
  const MendedMesh parted = part_combined(track_combined(all, solid), 1e-3);
  EXPECT_TRUE(parted.is_mended);
  EXPECT_GT(parted.largest_move, 0.0);
  EXPECT_LT(parted.largest_move, 1e-14);
  EXPECT_EQ(parted.mesh.soup.n_vertices(), 16U);
  EXPECT_EQ(parted.mesh.n_input_faces, 24U);
  std::set<Index> origins;
  for (Index f = 0; f < 24; ++f) origins.insert(parted.mesh.origin_of_face(f));
  EXPECT_EQ(origins.size(), 24U);
  EXPECT_EQ(*origins.rbegin(), 23U);
}

TEST(PartCombined, SliversStayOutward) {
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
    const std::vector<Soup> meshes{shapes::cube(), sliver};
    const Soup all = concatenate(meshes);
    const CombinedSolid solid = combine_solids(operands_of(all, meshes), union_rule());
    const MendedMesh parted = part_combined(track_combined(all, solid), 1e-3);
    n_parted += parted.is_mended ? 1 : 0;
    EXPECT_TRUE(is_good(parted.mesh.soup)) << trial;
  }
  EXPECT_GT(n_parted, 50U);
}

TEST(PartCombined, PartThatIsInsideOutIsOrientedOutwards) {
  const Soup inside_out = shapes::flipped(shapes::translated(shapes::tetrahedron(), {5, 0, 0}));
  const MendedMesh parted =
      part_combined(track_mesh(shapes::merged(shapes::cube(), inside_out)), 1e-3);
  EXPECT_TRUE(parted.is_mended);
  EXPECT_EQ(parted.largest_move, 0.0);
  EXPECT_TRUE(is_good(parted.mesh.soup));
}

TEST(PartCombined, ManifoldMeshStays) {
  const Combination cut(shapes::cube(2), shapes::cube(2, {1, 1, 1}));
  const TrackedMesh tracked = track_combined(cut.all, cut.solid);
  const MendedMesh parted = part_combined(tracked, 1e-3);
  EXPECT_FALSE(parted.is_mended);
  EXPECT_EQ(parted.mesh.soup.positions, tracked.soup.positions);
}

TEST(MendCombined, FacesThatStillIntersectAreCutAndTrackedToTheInput) {
  const Soup cubes = shapes::merged(shapes::cube(2), shapes::cube(2, {1, 1, 1}));
  const MendedMesh mended = mend_combined(track_mesh(cubes), {.max_deviation = 1e-3});
  EXPECT_TRUE(mended.is_mended);
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
  EXPECT_FALSE(is_embedded(combined.soup));
  const MendedMesh mended = mend_combined(combined, {.max_deviation = 1e-3});
  EXPECT_TRUE(is_embedded(mended.mesh.soup));
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
  const MendedMesh mended = mend_combined(
      track_mesh(cubes), {.max_deviation = 1e-3, .wants_to_stop = [] { return true; }});
  EXPECT_EQ(mended.mesh.soup.triangles, cubes.triangles);
}

TEST(KeepOff, MeshThatWasMovedIntoAnotherLosesWhatThatHas) {
  const Soup cube = shapes::cube(2);
  const Soup other = shapes::cube(1, {1.5, 1.25, 1.75});
  const MendedMesh apart = keep_off({track_mesh(cube), true, 1e-9}, other, {.max_deviation = 1e-3});
  const Soup& left = apart.mesh.soup;
  EXPECT_NEAR(volume_of(left), 8.0 - 0.5 * 0.75 * 0.25, 1e-9);
  EXPECT_TRUE(check_pair(left, other).empty());
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
  const MendedMesh same = keep_off({track_mesh(spheres), true, 0.0}, other, {.max_deviation = 0.0});
  EXPECT_EQ(same.mesh.soup.triangles, spheres.triangles);
  const MendedMesh cut = keep_off({track_mesh(spheres), true, 0.0}, other, {.max_deviation = 1e-3});
  EXPECT_TRUE(is_good(cut.mesh.soup));
  EXPECT_LE(cut.largest_move, 1e-3);
}

TEST(KeepOff, MeshThatMeetsNoOtherStays) {
  const Soup cube = shapes::cube(2);
  const MendedMesh same = keep_off({track_mesh(cube), true, 0.0}, shapes::cube(1, {3, 3, 3}), {});
  EXPECT_EQ(same.mesh.soup.positions, cube.positions);
  EXPECT_EQ(same.mesh.soup.triangles, cube.triangles);
}

}  // namespace
}  // namespace meshalyzer
