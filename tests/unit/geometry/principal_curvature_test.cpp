#include "curvature_of.h"
#include "meshalyzer/geometry/curvature.h"
#include "support/constants.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// The principal curvatures of measure_curvature().
namespace meshalyzer {
namespace {

/// A tube of n sides and `bands` bands of the given height round the z axis, open at both ends.
Soup tube(double radius, std::size_t n, std::size_t bands, double height) {
  Soup soup;
  for (std::size_t band = 0; band <= bands; ++band) {
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * kPi * static_cast<double>(i) / static_cast<double>(n);
      soup.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                  height * static_cast<double>(band));
    }
  }
  const auto at = [&](std::size_t band, std::size_t i) {
    return static_cast<Index>(band * n + i % n);
  };
  for (std::size_t band = 0; band < bands; ++band) {
    for (std::size_t i = 0; i < n; ++i) {
      soup.triangles.push_back({at(band, i), at(band, i + 1), at(band + 1, i + 1)});
      soup.triangles.push_back({at(band, i), at(band + 1, i + 1), at(band + 1, i)});
    }
  }
  return soup;
}

TEST(PrincipalCurvature, AnyPointsOnASphereHaveItsOwn) {
  // Normals by Max's weights are radial, so that they turn by exactly edge / radius along an edge.
  const double radius = 3.0;
  for (const Soup& ball : {shapes::icosphere(3), shapes::uv_sphere(7, 31)}) {
    const Curvature c = curvature_of(shapes::scaled(ball, radius));
    for (std::size_t v = 0; v < ball.n_vertices(); ++v) {
      EXPECT_NEAR(c.k1[v], 1 / radius, 1e-12);
      EXPECT_NEAR(c.k2[v], 1 / radius, 1e-12);
    }
  }
}

TEST(PrincipalCurvature, SphereHasNoDirections) {
  const Curvature c = curvature_of(shapes::icosphere(0));
  for (const Vec3& direction : c.direction1) EXPECT_EQ(direction, Vec3::Zero());
  for (const Vec3& direction : c.direction2) EXPECT_EQ(direction, Vec3::Zero());
}

TEST(PrincipalCurvature, CylinderIsExact) {
  // Two bands from the ends, half a turn about the radius maps the mesh round a vertex to itself:
  // the normal is radial. The tube unrolls to a plane, so K is 0. With sides w = 2 r sin(a) for
  // a = pi / n the cotangent vector is 2 h / w * 2 r (1 - cos 2a) = 4 h sin a long, over an area
  // w h: H = sin(a) / w = 1 / (2 r).
  const double radius = 2.0;
  const Soup soup = tube(radius, 9, 8, 0.7);
  const Curvature c = curvature_of(soup);
  for (std::size_t v = 4 * 9; v < 5 * 9; ++v) {
    ASSERT_EQ(c.state[v], CurvatureState::Defined);
    EXPECT_NEAR(c.gaussian[v], 0.0, 1e-14);
    EXPECT_NEAR(c.mean[v], 1 / (2 * radius), 1e-14);
    EXPECT_NEAR(c.k1[v], 1 / radius, 1e-14);
    EXPECT_NEAR(c.k2[v], 0.0, 1e-14);
    EXPECT_NEAR(std::abs(c.direction2[v].z()), 1.0, 1e-14);
    const Vec3 round = Vec3::UnitZ().cross(soup.positions[v]).normalized();
    EXPECT_NEAR(std::abs(c.direction1[v].dot(round)), 1.0, 1e-14);
  }
}

TEST(PrincipalCurvature, CylinderHasDirectionsWhicheverWayItLies) {
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(3, -1, 2)}) {
    Soup soup = tube(2.0, 9, 8, 0.7);
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), axis);
    for (Vec3& p : soup.positions) p = turn * p;
    const Curvature c = curvature_of(soup);
    for (std::size_t v = 4 * 9; v < 5 * 9; ++v) {
      EXPECT_NEAR(std::abs(c.direction2[v].dot(axis.normalized())), 1.0, 1e-14);
      EXPECT_NEAR(c.direction1[v].norm(), 1.0, 1e-14);
      EXPECT_NEAR(c.direction1[v].dot(c.direction2[v]), 0.0, 1e-14);
    }
  }
}

TEST(PrincipalCurvature, MirrorPlanesHaveTheDirections) {
  // An octahedron, flattened along z and of two other lengths: its tip bends most along the shorter
  // one.
  for (const bool is_x_shorter : {false, true}) {
    const double x = is_x_shorter ? 1.0 : 2.0;
    const double y = is_x_shorter ? 2.0 : 1.0;
    const Soup soup = shapes::make(
        {{0, 0, 0.5}, {x, 0, 0}, {0, y, 0}, {-x, 0, 0}, {0, -y, 0}, {0, 0, -0.5}},
        {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}});
    const Curvature c = curvature_of(soup);
    ASSERT_EQ(c.state[0], CurvatureState::Defined);
    EXPECT_GT(c.k1[0], c.k2[0]);
    const Vec3 shorter = is_x_shorter ? Vec3::UnitX() : Vec3::UnitY();
    const Vec3 longer = is_x_shorter ? Vec3::UnitY() : Vec3::UnitX();
    EXPECT_NEAR(std::abs(c.direction1[0].dot(shorter)), 1.0, 1e-14);
    EXPECT_NEAR(std::abs(c.direction2[0].dot(longer)), 1.0, 1e-14);
  }
}

TEST(PrincipalCurvature, SliversOnACylinderDoNotSpoilIt) {
  // Faces 1e9 times as wide as high.
  const Soup soup = tube(2.0, 9, 12, 1e-9);
  const Curvature c = curvature_of(soup);
  for (std::size_t v = 4 * 9; v < 9 * 9; ++v) {
    EXPECT_NEAR(c.mean[v], 0.25, 1e-9);
    EXPECT_NEAR(c.k1[v], 0.5, 1e-9);
    EXPECT_NEAR(c.k2[v], 0.0, 1e-6);
  }
}

struct TorusErrors {
  double curvature = 0.0;
  double direction = 0.0;
};

/// Largest errors on a torus of radii 2 and 1: 1 / r round the tube, cos(t) / (R + r cos(t)) round
/// the axis.
TorusErrors torus_errors(std::size_t n) {
  const Soup torus = shapes::torus(2, 1, 2 * n, n);
  const Curvature c = curvature_of(torus);
  TorusErrors worst;
  for (std::size_t v = 0; v < torus.n_vertices(); ++v) {
    const Vec3& p = torus.positions[v];
    const double from_axis = std::hypot(p.x(), p.y());
    const Vec3 round_axis = Vec3(-p.y(), p.x(), 0) / from_axis;
    worst.curvature = std::max({worst.curvature, std::abs(c.k1[v] - 1.0),
                                std::abs(c.k2[v] - (from_axis - 2) / from_axis)});
    worst.direction = std::max({worst.direction, std::abs(c.direction1[v].dot(round_axis)),
                                std::sqrt(1 - std::pow(c.direction2[v].dot(round_axis), 2))});
  }
  return worst;
}

TEST(PrincipalCurvature, TorusIsNearAndFourTimesNearerWithHalfTheSteps) {
  const TorusErrors coarse = torus_errors(24);
  const TorusErrors fine = torus_errors(48);
  EXPECT_LT(coarse.curvature, 0.03);
  EXPECT_LT(fine.curvature, coarse.curvature / 3);
  EXPECT_LT(coarse.direction, 0.03);
  EXPECT_LT(fine.direction, coarse.direction / 2);
}

TEST(PrincipalCurvature, SaddleHasBothSigns) {
  // z = (x² - y²) / 2 at the origin, facing up: bends up along x, which is negative, down along y.
  Soup saddle = shapes::grid(20, 20);
  for (Vec3& p : saddle.positions) {
    p = Vec3(p.x() / 20 - 0.5, p.y() / 20 - 0.5, 0);
    p.z() = (p.x() * p.x() - p.y() * p.y()) / 2;
  }
  const Curvature c = curvature_of(saddle);
  const std::size_t middle = 10 * 21 + 10;
  ASSERT_EQ(saddle.positions[middle], Vec3::Zero());
  EXPECT_NEAR(c.k1[middle], 1.0, 0.01);
  EXPECT_NEAR(c.k2[middle], -1.0, 0.01);
  EXPECT_NEAR(std::abs(c.direction1[middle].y()), 1.0, 0.01);
  EXPECT_NEAR(std::abs(c.direction2[middle].x()), 1.0, 0.01);
  EXPECT_NEAR(c.gaussian[middle], -1.0, 0.02);
  EXPECT_NEAR(c.mean[middle], 0.0, 0.01);
}

}  // namespace
}  // namespace meshalyzer
