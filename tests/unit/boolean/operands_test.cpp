#include "meshalyzer/boolean/operands.h"

#include "meshalyzer/base/error.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace meshalyzer {
namespace {

TEST(Concatenate, RecordsComeOneBehindTheOther) {
  const std::vector<Soup> meshes{shapes::tetrahedron(), shapes::cube()};
  const Soup all = concatenate(meshes);
  EXPECT_EQ(all.n_vertices(), 12U);
  EXPECT_EQ(all.n_faces(), 16U);
  for (std::size_t f = 0; f < 12; ++f) {
    EXPECT_EQ(corners_of(all, static_cast<Index>(4 + f)),
              corners_of(meshes[1], static_cast<Index>(f)));
  }
}

TEST(Concatenate, FaceOfAVertexOfTheNextMeshIsRefused) {
  std::vector<Soup> meshes{shapes::tetrahedron(), shapes::tetrahedron()};
  meshes[0].triangles[2][1] = 5;
  EXPECT_THROW(static_cast<void>(concatenate(meshes)), InvalidArgument);
}

TEST(Concatenate, FacesWithoutAGroupStayWithoutOne) {
  std::vector<Soup> meshes{shapes::tetrahedron(), shapes::tetrahedron(), shapes::tetrahedron()};
  meshes[0].groups = {{"a", 1}};
  meshes[2].groups = {{"c", 0}, {"d", 2}};
  const Soup all = concatenate(meshes);
  const auto name = [&](Index face) {
    const Index group = group_of(all, face);
    return group == kNoIndex ? std::string("none") : all.groups[group].name;
  };
  EXPECT_EQ(name(0), "none");
  EXPECT_EQ(name(1), "a");
  EXPECT_EQ(name(4), "");
  EXPECT_EQ(name(7), "");
  EXPECT_EQ(name(8), "c");
  EXPECT_EQ(name(10), "d");
}

TEST(Concatenate, CornersOfMeshesWithoutNormalsHaveNone) {
  std::vector<Soup> meshes{shapes::tetrahedron(), shapes::tetrahedron()};
  meshes[1].normals = {{1, 0, 0}};
  meshes[1].corner_normals.assign(4, {0, 0, 0});
  const Soup all = concatenate(meshes);
  ASSERT_EQ(all.corner_normals.size(), 8U);
  EXPECT_EQ(all.corner_normals[3], (Triangle{kNoIndex, kNoIndex, kNoIndex}));
  EXPECT_EQ(all.corner_normals[4], (Triangle{0, 0, 0}));
}

TEST(OperandsOf, EachComponentIsOne) {
  const Soup cubes = shapes::merged(shapes::cube(), shapes::cube(1, {3, 0, 0}));
  const Operands operands = operands_of(cubes);
  EXPECT_EQ(operands.count, 2U);
  EXPECT_EQ(operands.of_face[11], 0U);
  EXPECT_EQ(operands.of_face[12], 1U);
}

TEST(OperandsOf, WallOfACavityBelongsToItsSolid) {
  const Soup hollow = shapes::nested_cubes(shapes::InnerShell::Cavity);
  EXPECT_EQ(operands_of(hollow).count, 1U);
  // The wall of the cavity first.
  Soup turned = hollow;
  std::reverse(turned.triangles.begin(), turned.triangles.end());
  EXPECT_EQ(operands_of(turned).count, 1U);
  const Soup full = shapes::nested_cubes(shapes::InnerShell::Outward);
  EXPECT_EQ(operands_of(full).count, 2U);
}

TEST(OperandsOf, WallOfACavityThatBreaksThroughBelongsToTheSolidThatItCrosses) {
  const Soup alone = shapes::cube(1, {9, 0, 0});
  const Soup cavity = shapes::flipped(shapes::cube(1, {2.5, 1, 1}));
  const Soup all = shapes::merged(shapes::merged(alone, cavity), shapes::cube(3));
  const Operands operands = operands_of(all);
  EXPECT_EQ(operands.count, 2U);
  EXPECT_NE(operands.of_face[12], operands.of_face[0]);
  EXPECT_EQ(operands.of_face[12], operands.of_face[24]);
}

TEST(VolumesOf, EachOperandHasItsOwnWhereverItIs) {
  const std::vector<Soup> meshes{shapes::cube(2, {1e8, 0, 0}),
                                 shapes::nested_cubes(shapes::InnerShell::Cavity)};
  const Soup all = concatenate(meshes);
  const std::vector<double> volumes = volumes_of(operands_of(all, meshes));
  ASSERT_EQ(volumes.size(), 2U);
  EXPECT_NEAR(volumes[0], 8.0, 1e-6);
  EXPECT_NEAR(volumes[1], 26.0, 1e-6);
}

}  // namespace
}  // namespace meshalyzer
