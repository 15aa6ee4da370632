#include "area_volume.h"

#include "shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lab {
namespace {

constexpr double kTolerance = 1e-12;

TEST(FaceArea, OfTheWallsAndTheRoofOfTheTetrahedron) {
  const TriMesh mesh = shapes::tetrahedron();
  // Legs 1 and 1; sides sqrt(2), so sqrt(3) / 4 times 2.
  EXPECT_NEAR(face_area(mesh, FaceHandle(0)), 0.5, kTolerance);
  EXPECT_NEAR(face_area(mesh, FaceHandle(2)), std::sqrt(3.0) / 2.0, kTolerance);
}

TEST(FaceArea, DoesNotDependOnTheDirectionOfTheFace) {
  const TriMesh mesh = shapes::turned_inside_out(shapes::tetrahedron());
  EXPECT_NEAR(face_area(mesh, FaceHandle(2)), std::sqrt(3.0) / 2.0, kTolerance);
}

TEST(SurfaceArea, OfClosedFormShapes) {
  EXPECT_NEAR(surface_area(shapes::tetrahedron()), (3.0 + std::sqrt(3.0)) / 2.0, kTolerance);
  EXPECT_NEAR(surface_area(shapes::cube()), 24.0, kTolerance);
  EXPECT_NEAR(surface_area(shapes::octahedron()), 4.0 * std::sqrt(3.0), kTolerance);
}

TEST(SurfaceArea, OfAnOpenSurfaceToo) {
  EXPECT_NEAR(surface_area(shapes::square()), 4.0, kTolerance);
}

TEST(Volume, OfClosedFormShapes) {
  EXPECT_NEAR(volume(shapes::tetrahedron()).value(), 1.0 / 6.0, kTolerance);
  EXPECT_NEAR(volume(shapes::cube()).value(), 8.0, kTolerance);
  EXPECT_NEAR(volume(shapes::octahedron()).value(), 4.0 / 3.0, kTolerance);
}

TEST(Volume, DoesNotDependOnWhereTheMeshLies) {
  EXPECT_NEAR(volume(shapes::moved(shapes::tetrahedron(), Vec3(10, -20, 30))).value(), 1.0 / 6.0,
              1e-10);
}

TEST(Volume, IsNegativeWhereTheNormalsPointInwards) {
  EXPECT_NEAR(volume(shapes::turned_inside_out(shapes::cube())).value(), -8.0, kTolerance);
}

TEST(Volume, OfAnOpenSurfaceIsNothing) {
  EXPECT_FALSE(volume(shapes::open_octahedron()).has_value());
}

TEST(Volume, OfAnInscribedSphereIsThatOfItsPolyhedron) {
  // Between two rings of radius r and s, h apart, lies a frustum of a regular n-gon, of volume
  // n / 2 sin(2 pi / n) h (r r + r s + s s) / 3.
  constexpr int n = 16;
  constexpr double pi = std::numbers::pi;
  double polyhedron = 0.0;
  for (int ring = 0; ring < n; ++ring) {
    const double r = std::sin(pi * ring / n);
    const double s = std::sin(pi * (ring + 1) / n);
    const double h = std::cos(pi * ring / n) - std::cos(pi * (ring + 1) / n);
    polyhedron += n / 2.0 * std::sin(2.0 * pi / n) * h * (r * r + r * s + s * s) / 3.0;
  }
  EXPECT_NEAR(volume(shapes::sphere(n)).value(), polyhedron, kTolerance);
  EXPECT_LT(polyhedron, 4.0 / 3.0 * pi);
}

}  // namespace
}  // namespace lab
