#include "curvature.h"

#include "shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lab {
namespace {

constexpr double kTolerance = 1e-12;
constexpr double kPi = std::numbers::pi;

VertexHandle vertex(int i) {
  return VertexHandle(i);
}

TEST(AngleDefect, OfACornerOfTheCubeIsAQuarterTurn) {
  const TriMesh mesh = shapes::cube();
  for (const VertexHandle v : mesh.vertices()) {
    EXPECT_NEAR(angle_defect(mesh, v), kPi / 2.0, kTolerance);
  }
}

TEST(AngleDefect, OfAFlatVertexIsZero) {
  EXPECT_NEAR(angle_defect(shapes::square(), vertex(0)), 0.0, kTolerance);
}

double total_defect(const TriMesh& mesh) {
  double sum = 0.0;
  for (const VertexHandle v : mesh.vertices()) sum += angle_defect(mesh, v);
  return sum;
}

TEST(AngleDefect, SumsUpToTwoPiTimesTheEulerNumber) {
  EXPECT_NEAR(total_defect(shapes::sphere(12)), 4.0 * kPi, 1e-10);
  EXPECT_NEAR(total_defect(shapes::torus(12)), 0.0, 1e-10);
}

TEST(OneRingArea, IsThatOfAllFacesRoundTheVertex) {
  // Four equilateral faces with sides sqrt(2), each of area sqrt(3) / 2.
  EXPECT_NEAR(one_ring_area(shapes::octahedron(), vertex(0)), 2.0 * std::sqrt(3.0), kTolerance);
  EXPECT_NEAR(one_ring_area(shapes::square(), vertex(1)), 2.0, kTolerance);
}

TEST(VoronoiArea, OfEquilateralFacesIsAThirdOfThem) {
  EXPECT_NEAR(voronoi_area(shapes::octahedron(), vertex(0)), 2.0 / std::sqrt(3.0), kTolerance);
}

TEST(VoronoiArea, OfACornerOfTheCubeIsAQuarterOfThreeSides) {
  const TriMesh mesh = shapes::cube();
  for (const VertexHandle v : mesh.vertices()) {
    EXPECT_NEAR(voronoi_area(mesh, v), 3.0, kTolerance);
  }
}

TEST(VoronoiArea, SumsUpToTheAreaOfTheSurfaceEvenWhereFacesAreObtuse) {
  const TriMesh mesh = shapes::torus(7);
  double voronoi = 0.0;
  double one_ring = 0.0;
  for (const VertexHandle v : mesh.vertices()) {
    voronoi += voronoi_area(mesh, v);
    one_ring += one_ring_area(mesh, v);
  }
  EXPECT_NEAR(voronoi, one_ring / 3.0, 1e-10);
}

TEST(GaussianCurvature, OfTheOctahedron) {
  // (2 pi - 4 pi / 3) / (2 / sqrt(3))
  EXPECT_NEAR(gaussian_curvature(shapes::octahedron(), vertex(0)).value(), kPi / std::sqrt(3.0),
              kTolerance);
}

TEST(GaussianCurvature, OfAFineSphereIsOne) {
  const TriMesh mesh = shapes::sphere(32);
  for (const VertexHandle v : mesh.vertices()) {
    EXPECT_NEAR(gaussian_curvature(mesh, v).value(), 1.0, 0.01);
  }
}

TEST(GaussianCurvature, OfATorusHasTheSignOfItsSide) {
  // cos v / (2 + cos v): 1 / 3 on the outer equator (vertex 0), -1 on the inner one (vertex 20).
  const TriMesh mesh = shapes::torus(40);
  EXPECT_NEAR(gaussian_curvature(mesh, vertex(0)).value(), 1.0 / 3.0, 0.01);
  EXPECT_NEAR(gaussian_curvature(mesh, vertex(20)).value(), -1.0, 0.02);
}

TEST(GaussianCurvature, DoesNotDependOnTheSideOfTheSurface) {
  const TriMesh mesh = shapes::turned_inside_out(shapes::octahedron());
  EXPECT_NEAR(gaussian_curvature(mesh, vertex(0)).value(), kPi / std::sqrt(3.0), kTolerance);
}

TEST(GaussianCurvature, OnTheBorderAndAtOrphansIsNothing) {
  EXPECT_FALSE(gaussian_curvature(shapes::square(), vertex(1)).has_value());
  const TriMesh with_orphan = shapes::with_orphan(shapes::octahedron());
  EXPECT_FALSE(gaussian_curvature(with_orphan, vertex(6)).has_value());
}

TEST(GaussianCurvature, WhereTheVoronoiAreaIsNegativeIsNothing) {
  const TriMesh mesh = shapes::star();
  EXPECT_LT(voronoi_area(mesh, vertex(0)), 0.0);
  EXPECT_FALSE(gaussian_curvature(mesh, vertex(0)).has_value());
}

TEST(CotangentVector, OfTheOctahedronPointsOutwards) {
  // Both angles are 60 degrees, cot 60 + cot 60 = 2 / sqrt(3); the four neighbours cancel, and
  // four times the vertex is left.
  const Vec3 got = cotangent_vector(shapes::octahedron(), vertex(0));
  EXPECT_LT((got - Vec3(8.0 / std::sqrt(3.0), 0.0, 0.0)).norm(), kTolerance);
}

TEST(CotangentVector, OfAFlatVertexIsZeroHoweverTheFacesAreCut) {
  TriMesh mesh = shapes::square();
  mesh.set_point(vertex(0), Vec3(0.3, -0.2, 0.0));
  EXPECT_LT(cotangent_vector(mesh, vertex(0)).norm(), kTolerance);
}

TEST(MeanCurvature, OfTheOctahedronIsThatOfItsSphere) {
  EXPECT_NEAR(mean_curvature(shapes::octahedron(), vertex(0)).value(), 1.0, kTolerance);
}

TEST(MeanCurvature, OfTheCubeIsThatOfItsSphere) {
  const TriMesh mesh = shapes::cube();
  for (const VertexHandle v : mesh.vertices()) {
    EXPECT_NEAR(mean_curvature(mesh, v).value(), 1.0 / std::sqrt(3.0), kTolerance);
  }
}

TEST(MeanCurvature, IsNegativeInsideOut) {
  const TriMesh mesh = shapes::turned_inside_out(shapes::octahedron());
  EXPECT_NEAR(mean_curvature(mesh, vertex(0)).value(), -1.0, kTolerance);
}

TEST(MeanCurvature, OfADentIsNegativeAndOfAPeakPositive) {
  EXPECT_GT(mean_curvature(shapes::double_pyramid(0.5), vertex(0)).value(), 0.1);
  EXPECT_LT(mean_curvature(shapes::double_pyramid(-0.5), vertex(0)).value(), -0.1);
}

TEST(MeanCurvature, OfATorus) {
  // (2 + 2 cos v) / (2 (2 + cos v)): 2 / 3 on the outer equator, 0 on the inner one.
  const TriMesh mesh = shapes::torus(40);
  EXPECT_NEAR(mean_curvature(mesh, vertex(0)).value(), 2.0 / 3.0, 0.01);
  EXPECT_NEAR(mean_curvature(mesh, vertex(20)).value(), 0.0, 0.01);
}

TEST(MeanCurvature, OnTheBorderIsNothing) {
  EXPECT_FALSE(mean_curvature(shapes::square(), vertex(1)).has_value());
}

}  // namespace
}  // namespace lab
