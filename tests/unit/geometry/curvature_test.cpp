#include "meshalyzer/geometry/curvature.h"

#include "curvature_of.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/build.h"
#include "support/constants.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

namespace meshalyzer {
namespace {

constexpr double kSqrt3 = std::numbers::sqrt3;
constexpr std::array kAreas{VertexArea::Mixed, VertexArea::Voronoi, VertexArea::Barycentric,
                            VertexArea::OneRing};

/// Corners (0, 0, +-h) over and under a regular triangle of circumradius 1.
Soup bipyramid(double h) {
  const double s = kSqrt3 / 2;
  return shapes::make({{0, 0, h}, {0, 0, -h}, {1, 0, 0}, {-0.5, s, 0}, {-0.5, -s, 0}},
                      {{0, 2, 3}, {0, 3, 4}, {0, 4, 2}, {1, 3, 2}, {1, 4, 3}, {1, 2, 4}});
}

Soup octahedron() {
  return shapes::make(
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{4, 0, 2}, {4, 2, 1}, {4, 1, 3}, {4, 3, 0}, {5, 2, 0}, {5, 1, 2}, {5, 3, 1}, {5, 0, 3}});
}

/// Every vertex of a shape where all are alike.
struct Expected {
  double defect = 0.0;
  double area = 0.0;
  double mean = 0.0;
  double one_ring_factor = 3.0;
};

void expect_alike(const Soup& soup, const Expected& expected) {
  for (const VertexArea area : kAreas) {
    const double factor = area == VertexArea::OneRing ? expected.one_ring_factor : 1.0;
    const Curvature c = curvature_of(soup, area);
    ASSERT_EQ(c.state.size(), soup.n_vertices());
    for (std::size_t v = 0; v < c.state.size(); ++v) {
      EXPECT_EQ(c.state[v], CurvatureState::Defined);
      EXPECT_NEAR(c.angle_defect[v], expected.defect, 1e-14);
      EXPECT_NEAR(c.area[v], factor * expected.area, 1e-14);
      EXPECT_NEAR(c.gaussian[v], expected.defect / (factor * expected.area), 1e-14);
      EXPECT_NEAR(c.mean[v], expected.mean / factor, 1e-14);
      // All vertices are on a sphere round the origin.
      EXPECT_NEAR(c.k1[v], 1.0 / soup.positions[v].norm(), 1e-13);
      EXPECT_NEAR(c.k2[v], 1.0 / soup.positions[v].norm(), 1e-13);
    }
  }
}

TEST(Curvature, OctahedronHasItsClosedForm) {
  // At a vertex four equilateral faces of area sqrt(3) / 2: 2 pi - 4 pi / 3, and a third of each.
  // The cotangents are 1 / sqrt(3), and the neighbours sum up to 0: the vector is 4 * 2 / sqrt(3)
  // times the vertex, H that over 4 * 2 / sqrt(3).
  expect_alike(octahedron(), {.defect = 2 * kPi / 3, .area = 2 / kSqrt3, .mean = 1.0});
}

TEST(Curvature, RegularTetrahedronHasItsClosedForm) {
  // Three faces of area 2 sqrt(3): 2 pi - pi. The vector is 2 / sqrt(3) (3 p + p), 8 long.
  const Soup tetrahedron = shapes::make({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                                        {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
  expect_alike(tetrahedron, {.defect = kPi, .area = 2 * kSqrt3, .mean = 1 / kSqrt3});
}

TEST(Curvature, IcosahedronHasItsClosedForm) {
  // Five faces of edge a = 1 / sin(2 pi / 5): 2 pi - 5 pi / 3, a third of 5 sqrt(3) / 4 a². The
  // five neighbours are p cos(b) on average with |p - q| = a, 2 - 2 cos b = a²: the vector is 5 * 2
  // / sqrt(3) (1 - cos b) = 5 a² / sqrt(3) long, H that over 5 a² / sqrt(3).
  const double a = 1 / std::sin(2 * kPi / 5);
  expect_alike(shapes::icosphere(0),
               {.defect = kPi / 3, .area = 5 * a * a / (4 * kSqrt3), .mean = 1.0});
}

TEST(Curvature, CubeHasItsClosedForm) {
  // Three right angles; a quarter of each square, whichever way it is cut. Diagonals have the
  // cotangent 0, sides 1 and 1: the vector is 2 (2, 2, 2), H = 4 sqrt(3) / (4 * 3).
  const Soup cube = shapes::cube(2.0, {-1, -1, -1});
  for (const VertexArea area : {VertexArea::Mixed, VertexArea::Voronoi}) {
    const Curvature c = curvature_of(cube, area);
    for (std::size_t v = 0; v < 8; ++v) {
      EXPECT_NEAR(c.area[v], 3.0, 1e-14);
      EXPECT_NEAR(c.gaussian[v], kPi / 6, 1e-14);
      EXPECT_NEAR(c.mean[v], 1 / kSqrt3, 1e-14);
    }
  }
  // Every face has the area 2, and counts in full.
  std::vector<int> faces(8, 0);
  for (const Triangle& t : cube.triangles) {
    for (const Index v : t) ++faces[v];
  }
  const Curvature c = curvature_of(cube, VertexArea::OneRing);
  for (std::size_t v = 0; v < 8; ++v) EXPECT_NEAR(c.gaussian[v], kPi / 2 / (2 * faces[v]), 1e-14);
}

TEST(Curvature, ObtuseFacesAreHalvedAndQuartered) {
  // h = 1/2: sides 1.25 and 1.25 and 3 squared, the scalar products -1/4 at the pole and 3/2 on the
  // equator, the area A with A² = 3/8. The cotangents are these products over 2 A: the
  // circumcentric part of the pole is 2 * 1.25 * 1.5 / (16 A) = 5/8 A, on the equator 3/16 A.
  const double area = std::sqrt(3.0 / 8);
  const double pole_defect = 2 * kPi - 3 * std::acos(-0.2);
  const Curvature mixed = curvature_of(bipyramid(0.5), VertexArea::Mixed);
  EXPECT_NEAR(mixed.area[0], 1.5 * area, 1e-14);
  EXPECT_NEAR(mixed.area[2], area, 1e-14);
  EXPECT_NEAR(mixed.gaussian[0], pole_defect / (1.5 * area), 1e-14);
  const Curvature voronoi = curvature_of(bipyramid(0.5), VertexArea::Voronoi);
  EXPECT_NEAR(voronoi.area[0], 3 * 0.625 * area, 1e-14);
  EXPECT_NEAR(voronoi.area[2], 4 * 0.1875 * area, 1e-14);
  EXPECT_NEAR(voronoi.gaussian[0], pole_defect / (1.875 * area), 1e-14);
  // The vector at the pole: six cotangents 1.5 / (2 A) times h, across which the neighbours cancel.
  EXPECT_NEAR(voronoi.mean[0], 6 * 0.75 / area * 0.5 / (4 * 1.875 * area), 1e-13);
}

TEST(Curvature, AreasSumUpToTheSurface) {
  const Soup torus = shapes::torus(2, 0.7, 9, 5);
  const double surface = [&] {
    double sum = 0.0;
    for (Index f = 0; f < torus.n_faces(); ++f) {
      const auto p = corners_of(torus, f);
      sum += (p[1] - p[0]).cross(p[2] - p[0]).norm() / 2;
    }
    return sum;
  }();
  for (const VertexArea area : kAreas) {
    double sum = 0.0;
    for (const double x : curvature_of(torus, area).area) sum += x;
    EXPECT_NEAR(sum, area == VertexArea::OneRing ? 3 * surface : surface, 1e-12);
  }
}

TEST(Curvature, OneRingIsAThirdOfBarycentric) {
  const Soup torus = shapes::torus(2, 0.7, 9, 5);
  const Curvature third = curvature_of(torus, VertexArea::OneRing);
  const Curvature whole = curvature_of(torus, VertexArea::Barycentric);
  for (std::size_t v = 0; v < torus.n_vertices(); ++v) {
    EXPECT_NEAR(third.gaussian[v] * 3, whole.gaussian[v], 1e-13);
    EXPECT_NEAR(third.mean[v] * 3, whole.mean[v], 1e-13);
    EXPECT_EQ(third.k1[v], whole.k1[v]);
  }
}

TEST(Curvature, TurningTheFacesTurnsTheSigns) {
  const Soup torus = shapes::torus(2, 0.7, 24, 15);
  const Curvature out = curvature_of(torus);
  const Curvature in = curvature_of(shapes::flipped(torus));
  for (std::size_t v = 0; v < torus.n_vertices(); ++v) {
    EXPECT_NEAR(in.gaussian[v], out.gaussian[v], 1e-12);
    EXPECT_NEAR(in.mean[v], -out.mean[v], 1e-13);
    EXPECT_NEAR(in.k1[v], -out.k2[v], 1e-13);
    EXPECT_NEAR(in.k2[v], -out.k1[v], 1e-13);
  }
}

TEST(Curvature, MeanIsNegativeInADent) {
  // The cube with the middle of its top pushed in; the top has four faces round it.
  Soup dented = shapes::open_cube();
  const auto top = [&](double x, double y) {
    for (Index v = 0; v < 8; ++v) {
      if (dented.positions[v] == Vec3(x, y, 1)) return v;
    }
    return kNoIndex;
  };
  const std::array ring{top(0, 0), top(1, 0), top(1, 1), top(0, 1)};
  dented.positions.emplace_back(0.5, 0.5, 0.5);
  for (std::size_t i = 0; i < 4; ++i) {
    dented.triangles.push_back({8, ring[i], ring[(i + 1) % 4]});
  }
  const Curvature c = curvature_of(dented);
  ASSERT_EQ(c.state[8], CurvatureState::Defined);
  EXPECT_LT(c.mean[8], 0.0);
  EXPECT_GT(c.gaussian[8], 0.0);
}

/// The same bits, NaN or not.
void expect_same(const std::vector<double>& a, std::vector<double> b, double factor) {
  for (double& x : b) x *= factor;
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0);
}

TEST(Curvature, ScalingByAPowerOfTwoLosesNothing) {
  const Soup torus = shapes::torus(2, 0.7, 24, 15);
  for (const VertexArea area : kAreas) {
    const Curvature one = curvature_of(torus, area);
    for (const int exponent : {-300, -7, 1, 300}) {
      const double size = std::ldexp(1.0, exponent);
      const Curvature c = curvature_of(shapes::scaled(torus, size), area);
      EXPECT_EQ(c.state, one.state);
      EXPECT_EQ(c.angle_defect, one.angle_defect);
      expect_same(c.gaussian, one.gaussian, 1 / size / size);
      expect_same(c.mean, one.mean, 1 / size);
      expect_same(c.k1, one.k1, 1 / size);
      expect_same(c.k2, one.k2, 1 / size);
      EXPECT_EQ(c.direction1, one.direction1);
    }
  }
}

TEST(Curvature, ExtremeSizesHaveFiguresOrSayWhyNot) {
  for (const double size : {1e-320, 1e-170, 1e-150, 1e-90, 1e90, 1e150, 1e170, 1e307}) {
    for (const VertexArea area : kAreas) {
      const Curvature c = curvature_of(shapes::scaled(shapes::icosphere(1), size), area);
      const bool in_range = size > 1e-151 && size < 1e151;
      for (std::size_t v = 0; v < c.state.size(); ++v) {
        EXPECT_EQ(c.state[v], in_range ? CurvatureState::Defined : CurvatureState::NoArea);
        EXPECT_EQ(std::isfinite(c.gaussian[v]), in_range);
        // At 1e-320 positions have four digits.
        EXPECT_NEAR(c.angle_defect[v], kPi / 20, kPi / 20);
        if (in_range) {
          EXPECT_NEAR(c.k2[v] * size, 1.0, 1e-12);
        }
      }
    }
  }
}

TEST(Curvature, NumberOfThreadsDoesNotMatter) {
  const CutMesh cut = build(shapes::torus(3, 1, 200, 100));
  const ThreadLimit one(1);
  const Curvature sequential = measure_curvature(cut);
  const ThreadLimit two(2);
  const Curvature parallel = measure_curvature(cut);
  EXPECT_EQ(parallel.angle_defect, sequential.angle_defect);
  EXPECT_EQ(parallel.mean, sequential.mean);
  EXPECT_EQ(parallel.k1, sequential.k1);
  EXPECT_EQ(parallel.direction2, sequential.direction2);
}

TEST(Curvature, NoVerticesHaveNone) {
  EXPECT_TRUE(curvature_of(Soup{}).state.empty());
}

TEST(VertexAreaNames, AreReadBack) {
  for (const VertexArea area : kAreas) EXPECT_EQ(vertex_area(area_name(area)), area);
  EXPECT_EQ(area_name(VertexArea::OneRing), "one-ring");
  EXPECT_EQ(vertex_area("voronoi"), VertexArea::Voronoi);
  EXPECT_FALSE(vertex_area("Voronoi").has_value());
  EXPECT_FALSE(vertex_area("").has_value());
}

}  // namespace
}  // namespace meshalyzer
