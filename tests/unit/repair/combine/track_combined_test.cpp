#include "meshalyzer/repair/combine/track_combined.h"

#include "support/shapes.h"
#include "unit/repair/combine/combination.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace meshalyzer {
namespace {

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

}  // namespace
}  // namespace meshalyzer
