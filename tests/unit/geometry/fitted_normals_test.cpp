#include "meshalyzer/geometry/fitted_normals.h"

#include "meshalyzer/geometry/vertex_normals.h"
#include "meshalyzer/mesh/build.h"
#include "support/curved_shapes.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <utility>

namespace meshalyzer {
namespace {

/// The largest angle between two normals of a vertex, as a sine.
double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sine = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v) sine = std::max(sine, a[v].cross(b[v]).norm());
  return sine;
}

/// Returns how far fitted normals are from the true ones of an irregular mesh.
double error_at(shapes::Surface surface, std::size_t level) {
  const shapes::CurvedShape shape = curved_shape(surface, shapes::Meshing::Irregular, level);
  const CutMesh cut = build(shape.soup);
  std::vector<Vec3> truth;
  for (const shapes::TrueCurvature& t : shape.truth) truth.push_back(t.normal);
  return farthest(fitted_normals(cut.mesh, vertex_normals(cut)), truth);
}

TEST(FittedNormals, KeepTheRadialNormalsOfASphere) {
  // The sphere p^2 = 2 r z in the frame of its normal is among the quadrics fitted.
  const CutMesh cut =
      build(curved_shape(shapes::Surface::Sphere, shapes::Meshing::Irregular, 2).soup);
  std::vector<Vec3> radial;
  for (const VertexHandle v : cut.mesh.vertices()) radial.push_back(cut.mesh.point(v));
  EXPECT_LT(farthest(fitted_normals(cut.mesh, radial), radial), 1e-12);
}

TEST(FittedNormals, FindThePlaneFromTiltedOnes) {
  const CutMesh cut = build(shapes::grid(6, 5));
  const std::vector<Vec3> tilted(cut.mesh.n_vertices(), Vec3(0.3, -0.2, 1).normalized());
  const std::vector<Vec3> fitted = fitted_normals(cut.mesh, tilted);
  for (const VertexHandle v : cut.mesh.vertices()) {
    // The two corners with one face see too few points.
    if (cut.mesh.valence(v) == 2) continue;
    EXPECT_LT((fitted[static_cast<std::size_t>(v.idx())] - Vec3::UnitZ()).norm(), 1e-12);
  }
}

TEST(FittedNormals, AreWrongByTheSquareOfTheEdgeLengthOnIrregularMeshes) {
  for (const shapes::Surface surface : {shapes::Surface::Torus, shapes::Surface::Catenoid}) {
    EXPECT_LT(error_at(surface, 4), error_at(surface, 3) / 2.5);
  }
}

TEST(FittedNormals, StayAsGivenWhereThePointsAreTooFew) {
  // Three neighbours and nothing behind them.
  const CutMesh cut = build(shapes::tetrahedron());
  const std::vector<Vec3> given = vertex_normals(cut);
  EXPECT_EQ(fitted_normals(cut.mesh, given), given);
}

TEST(FittedNormals, StayAsGivenWhereThePointsAreNearNoQuadric) {
  // Heights of up to three edges, up or down, at random.
  std::mt19937 random(1);
  Soup rough = shapes::grid(5, 5);
  for (Vec3& p : rough.positions) p.z() = static_cast<double>(random() % 7) - 3.0;
  const CutMesh cut = build(rough);
  const std::vector<Vec3> given(cut.mesh.n_vertices(), Vec3::UnitZ());
  // The middle, with a full ring of neighbours and a ring of theirs.
  const std::size_t middle = 2 * 6 + 2;
  EXPECT_EQ(fitted_normals(cut.mesh, given)[middle], given[middle]);
}

TEST(FittedNormals, StayAsGivenAtTheHubOfAFan) {
  // A cone of 40 faces: its rim sees the hub, but not what lies across.
  Soup cone = shapes::make({Vec3(0, 0, 1)}, {});
  for (Index i = 0; i < 40; ++i) {
    const double turn = 2 * std::numbers::pi * i / 40;
    cone.positions.emplace_back(std::cos(turn), std::sin(turn), 0.0);
    cone.triangles.push_back({0, 1 + i, 1 + (i + 1) % 40});
  }
  const CutMesh cut = build(cone);
  std::vector<Vec3> given = vertex_normals(cut);
  given[0] = Vec3(0.1, 0, 1).normalized();
  EXPECT_EQ(fitted_normals(cut.mesh, given)[0], given[0]);
}

TEST(FittedNormals, StayZeroWhereThereIsNone) {
  const CutMesh cut = build(shapes::icosphere(1));
  std::vector<Vec3> given = vertex_normals(cut);
  given[7] = Vec3::Zero();
  EXPECT_EQ(fitted_normals(cut.mesh, given)[7], Vec3::Zero());
}

TEST(FittedNormals, LookAtOneSideOfAThinWallOnly) {
  // A slab of 6 x 6 x 0.01: where its sides meet, the points of the other side are left out, so
  // that one edge from the rim the normal is still that of the side.
  Soup slab = shapes::grid(6, 6);
  Soup under = shapes::flipped(shapes::translated(slab, Vec3(0, 0, -0.01)));
  const auto at = [](Index i, Index j) { return j * 7 + i; };
  Soup both = shapes::merged(slab, under);
  for (Index i = 0; i < 6; ++i) {
    // Each rim edge from a to b of the upper side, and the one below it.
    for (const auto& [a, b] :
         {std::pair{at(i, 0), at(i + 1, 0)}, std::pair{at(6, i), at(6, i + 1)},
          std::pair{at(i + 1, 6), at(i, 6)}, std::pair{at(0, i + 1), at(0, i)}}) {
      both.triangles.push_back({b, a, a + 49});
      both.triangles.push_back({b, a + 49, b + 49});
    }
  }
  const CutMesh cut = build(both);
  std::vector<Vec3> given(98, Vec3::UnitZ());
  std::fill(given.begin() + 49, given.end(), -Vec3::UnitZ());
  EXPECT_LT(farthest(fitted_normals(cut.mesh, given), given), 1e-12);
}

TEST(FittedNormals, AreNumbersAtAnySize) {
  for (const double size : {1e-300, 1e-150, 1e150, 1e307}) {
    const CutMesh cut = build(shapes::scaled(shapes::torus(2, 1, 12, 8), size / 3));
    const std::vector<Vec3> given = vertex_normals(cut);
    for (const Vec3& normal : fitted_normals(cut.mesh, given)) {
      EXPECT_NEAR(normal.norm(), 1.0, 1e-14);
    }
  }
}

}  // namespace
}  // namespace meshalyzer
