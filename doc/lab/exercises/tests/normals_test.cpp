#include "normals.h"

#include "shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lab {
namespace {

constexpr double kTolerance = 1e-12;

void expect_near(const Vec3& got, const Vec3& want) {
  EXPECT_LT((got - want).norm(), kTolerance) << got.transpose() << " is not " << want.transpose();
}

TEST(FaceNormal, OfTheOctahedronPointsAwayFromTheMiddle) {
  const TriMesh mesh = shapes::octahedron();
  for (const FaceHandle f : mesh.faces()) {
    expect_near(face_normal(mesh, f), mesh.calc_face_centroid(f).normalized());
  }
}

TEST(FaceNormal, TurnsWithTheOrderOfTheCorners) {
  const TriMesh mesh = shapes::octahedron();
  const TriMesh turned = shapes::turned_inside_out(mesh);
  for (const FaceHandle f : mesh.faces()) {
    expect_near(face_normal(turned, f), -face_normal(mesh, f));
  }
}

TEST(FaceNormal, OfAFaceWithoutAreaIsZero) {
  TriMesh mesh = shapes::octahedron();
  mesh.set_point(VertexHandle(0), mesh.point(VertexHandle(1)));
  expect_near(face_normal(mesh, FaceHandle(0)), Vec3::Zero());
}

TEST(VertexNormal, OfTheOctahedronIsItsPlace) {
  const TriMesh mesh = shapes::octahedron();
  for (const VertexHandle v : mesh.vertices()) expect_near(vertex_normal(mesh, v), mesh.point(v));
}

TEST(VertexNormal, LeansTowardsTheSideThatIsCutInTwo) {
  // At (-1, -1, -1) all three sides of the cube have two triangles; at (1, -1, -1), vertex 1, the
  // bottom and the front have one, and the right has two: -z, -y, 2 x, and of length sqrt(6).
  const TriMesh mesh = shapes::cube();
  expect_near(vertex_normal(mesh, VertexHandle(0)), Vec3(-1, -1, -1) / std::sqrt(3.0));
  expect_near(vertex_normal(mesh, VertexHandle(1)), Vec3(2, -1, -1) / std::sqrt(6.0));
}

TEST(VertexNormal, CountsASmallFaceAsMuchAsALargeOne) {
  // At the origin of the tetrahedron the three walls count the same however long their sides.
  TriMesh mesh = shapes::tetrahedron();
  mesh.set_point(VertexHandle(1), Vec3(5, 0, 0));
  expect_near(vertex_normal(mesh, VertexHandle(0)), Vec3(-1, -1, -1) / std::sqrt(3.0));
}

TEST(VertexNormal, OfAnOrphanIsZero) {
  const TriMesh mesh = shapes::with_orphan(shapes::octahedron());
  expect_near(vertex_normal(mesh, VertexHandle(6)), Vec3::Zero());
}

TEST(VertexNormal, WhereTwoFacesCancelIsZero) {
  TriMesh mesh;
  const auto a = mesh.add_vertex(Vec3(0, 0, 0));
  const auto b = mesh.add_vertex(Vec3(1, 0, 0));
  const auto c = mesh.add_vertex(Vec3(0, 1, 0));
  const auto d = mesh.add_vertex(Vec3(0, 2, 0));
  mesh.add_face(a, b, c);
  mesh.add_face(b, a, d);
  expect_near(vertex_normal(mesh, a), Vec3::Zero());
}

TEST(AngleWeightedNormal, OfACubeIsItsDiagonalHoweverTheSidesAreCut) {
  const TriMesh mesh = shapes::cube();
  for (const VertexHandle v : mesh.vertices()) {
    expect_near(angle_weighted_normal(mesh, v), mesh.point(v) / std::sqrt(3.0));
  }
}

TEST(AngleWeightedNormal, OnTheBorderCountsOnlyFaces) {
  expect_near(angle_weighted_normal(shapes::square(), VertexHandle(1)), Vec3(0, 0, 1));
}

TEST(AngleWeightedNormal, OfAnOrphanIsZero) {
  const TriMesh mesh = shapes::with_orphan(shapes::octahedron());
  expect_near(angle_weighted_normal(mesh, VertexHandle(6)), Vec3::Zero());
}

}  // namespace
}  // namespace lab
