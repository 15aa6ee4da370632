#include "meshalyzer/spatial/winding_number.h"

#include "support/effort.h"
#include "support/random_soups.h"
#include "support/shapes.h"
#include "support/triangles_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace meshalyzer {
namespace {

double winding(const Soup& soup, const Vec3& point) {
  return WindingNumbers(test::triangles_of(soup)).at(point);
}

double in_unit(std::mt19937& random) {
  return static_cast<double>(random()) / 0x1p32;
}

/// Even in a cube of side 2 `half` about the origin.
Vec3 random_point(std::mt19937& random, double half) {
  const double x = in_unit(random);
  const double y = in_unit(random);
  const double z = in_unit(random);
  return half * (2.0 * Vec3(x, y, z) - Vec3::Ones());
}

/// The share of the directions from a point by the excess of the spherical triangle (Girard): the
/// angles between the planes through the point and the edges, less pi.
double share_by_excess(const Corners& t, const Vec3& point) {
  const Corners d{t[0] - point, t[1] - point, t[2] - point};
  double excess = -std::numbers::pi;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 u = d[i].cross(d[(i + 1) % 3]);
    const Vec3 v = d[i].cross(d[(i + 2) % 3]);
    excess += std::atan2(u.cross(v).norm(), u.dot(v));
  }
  return std::copysign(excess, d[0].dot(d[1].cross(d[2]))) / (4.0 * std::numbers::pi);
}

double winding_by_excess(const std::vector<Corners>& triangles, const Vec3& point) {
  double sum = 0.0;
  for (const Corners& t : triangles) sum += share_by_excess(t, point);
  return sum;
}

TEST(WindingNumbers, NothingGoesRoundNothing) {
  EXPECT_EQ(WindingNumbers({}).at({1, 2, 3}), 0.0);
}

TEST(WindingNumbers, ClosedSurfaceHasOneInsideAndZeroOutside) {
  EXPECT_NEAR(winding(shapes::cube(), {0.25, 0.5, 0.75}), 1.0, 1e-12);
  EXPECT_NEAR(winding(shapes::cube(), {1.25, 0.5, 0.75}), 0.0, 1e-12);
  EXPECT_NEAR(winding(shapes::icosphere(4), {0.1, 0.2, 0.9}), 1.0, 0.01);
  EXPECT_NEAR(winding(shapes::torus(3, 1, 60, 30), {0, 0, 0}), 0.0, 0.01);
  EXPECT_NEAR(winding(shapes::torus(3, 1, 60, 30), {0, 3, 0}), 1.0, 0.01);
}

TEST(WindingNumbers, ReversedSurfaceHasTheNegativeToTheLastBit) {
  std::mt19937 random(1);
  for (const Soup& soup : {shapes::icosphere(3), damaged(shapes::icosphere(3), 8, random)}) {
    std::vector<Corners> turned = test::triangles_of(soup);
    for (Corners& t : turned) std::swap(t[1], t[2]);
    for (const ExpectedQueries expected : {ExpectedQueries::Few, ExpectedQueries::Many}) {
      const WindingNumbers as_is(test::triangles_of(soup), expected);
      const WindingNumbers reversed(turned, expected);
      for (int i = 0; i < 200; ++i) {
        const Vec3 point = random_point(random, 1.5);
        EXPECT_EQ(reversed.at(point), -as_is.at(point));
      }
    }
  }
}

TEST(WindingNumbers, ClosedSurfaceHasWholeNumbersWhereRaysAreUsed) {
  const Soup twice = shapes::merged(shapes::icosphere(3), shapes::cube(3.0, Vec3::Constant(-1.5)));
  const WindingNumbers numbers(test::triangles_of(twice), ExpectedQueries::Many);
  EXPECT_EQ(numbers.at({0.1, 0.2, 0.3}), 2.0);
  EXPECT_EQ(numbers.at({1.4, 1.3, -1.2}), 1.0);
  EXPECT_EQ(numbers.at({1.6, 0.1, 0.2}), 0.0);
}

TEST(WindingNumbers, TriangleAcrossAnOctantIsAnEighth) {
  const Soup octant = shapes::make({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}});
  EXPECT_NEAR(winding(octant, Vec3::Zero()), 0.125, 1e-15);
}

TEST(WindingNumbers, SquareFromAboveIsOneSideOfACube) {
  // Seen from the middle of a cube each of the six sides is a sixth; a grid has normals up.
  for (const std::size_t n : {2U, 8U, 64U}) {
    const auto side = static_cast<double>(n);
    EXPECT_NEAR(winding(shapes::grid(n, n), {side / 2, side / 2, side / 2}), -1.0 / 6.0, 0.005);
    EXPECT_NEAR(winding(shapes::grid(n, n), {side / 2, side / 2, -side / 2}), 1.0 / 6.0, 0.005);
  }
}

TEST(WindingNumbers, BoxWithoutItsLidLacksWhatTheLidWas) {
  EXPECT_NEAR(winding(shapes::open_cube(), {0.5, 0.5, 0.5}), 5.0 / 6.0, 1e-12);
}

TEST(WindingNumbers, PointOnAFaceIsHalfWayBetweenItsSides) {
  EXPECT_NEAR(winding(shapes::cube(), {1.0, 0.25, 0.5}), 0.5, 1e-9);
  EXPECT_NEAR(winding(shapes::cube(), {1.0, 0.5, 0.5}), 0.5, 1e-9);
  EXPECT_NEAR(winding(shapes::cube(3.0), {2.9999999999999, 1, 2}), 0.5, 1e-9);
  EXPECT_EQ(winding(shapes::grid(1, 1), {0.75, 0.5, 0.0}), 0.0);
}

TEST(WindingNumbers, PointOfAnEdgeOrCornerHasAFiniteAnswer) {
  // A quarter of all directions from an edge of a cube go inside, from a corner an eighth.
  EXPECT_NEAR(winding(shapes::cube(), {1.0, 1.0, 0.5}), 0.25, 1e-9);
  EXPECT_NEAR(winding(shapes::cube(), {1.0, 1.0, 1.0}), 0.125, 1e-9);
}

TEST(WindingNumbers, SurfaceGoneRoundTwiceHasTwo) {
  const Soup twice = shapes::merged(shapes::icosphere(2), shapes::icosphere(2));
  EXPECT_NEAR(winding(twice, {0.1, 0.1, 0.1}), 2.0, 0.02);
}

TEST(WindingNumbers, TrianglesWithoutAreaCountForNothing) {
  const Soup soup = shapes::make({{0, 0, 0}, {0.1, 0.3, 0.7}, {0.2, 0.6, 1.4}, {0, 0, 0}},
                                 {{0, 1, 2}, {0, 1, 3}, {0, 3, 0}});
  for (const double t : {-1.0, 0.0, 0.25, 0.5, 1.0, 1.5, 2.0}) {
    EXPECT_NEAR(winding(soup, t * soup.positions[1]), 0.0, 1e-12);
  }
}

TEST(WindingNumbers, AgreeWithTheSumOverAllTrianglesByExcess) {
  std::mt19937 random(7);
  double worst = 0.0;
  double worst_coarse = 0.0;
  for (const Soup& soup : {shapes::icosphere(4), damaged(shapes::torus(2, 1, 60, 30), 8, random),
                           shapes::genus_block(20), damaged(shapes::icosphere(4), 2, random)}) {
    Box3 box;
    for (const Vec3& p : soup.positions) box.extend(p);
    const std::vector<Corners> triangles = test::triangles_of(soup);
    const WindingNumbers few(triangles);
    const WindingNumbers many(triangles, ExpectedQueries::Many);
    const WindingNumbers coarse(triangles, ExpectedQueries::Few, WindingAccuracy::Coarse);
    for (std::size_t i = 0; i < 300; i += test::one_of()) {
      const Vec3 point = box.center() + random_point(random, 0.6 * box.sizes().maxCoeff());
      const double expected = winding_by_excess(triangles, point);
      worst = std::max(worst, std::abs(few.at(point) - expected));
      worst = std::max(worst, std::abs(many.at(point) - expected));
      worst_coarse = std::max(worst_coarse, std::abs(coarse.at(point) - expected));
    }
  }
  EXPECT_LT(worst, 0.01);
  EXPECT_LT(worst_coarse, 0.03);
  EXPECT_GT(worst_coarse, worst);
}

TEST(WindingNumbers, FarSurfaceIsExactToTheThirdTerm) {
  // Eight triangles are one node. The terms of their expansion fall with the powers -2, -3 and -4
  // of the distance, so that what is left out falls with the fifth.
  std::mt19937 random(23);
  double worst = 0.0;
  for (int i = 0; i < 20; ++i) {
    std::vector<Corners> triangles(8);
    for (Corners& t : triangles) {
      for (Vec3& p : t) p = random_point(random, 1.0);
    }
    const WindingNumbers numbers(triangles);
    for (const double distance : {16.0, 32.0, 64.0}) {
      const Vec3 point = distance * random_point(random, 1.0).normalized();
      const double error = std::abs(numbers.at(point) - winding_by_excess(triangles, point));
      worst = std::max(worst, error * std::pow(distance, 5.0));
    }
  }
  EXPECT_LT(worst, 0.5);
}

TEST(WindingNumbers, BothOfTwoPointsHaveWhatEachHasAlone) {
  std::mt19937 random(19);
  const Soup soup = damaged(shapes::torus(2, 1, 60, 30), 8, random);
  const WindingNumbers numbers(test::triangles_of(soup));
  for (int i = 0; i < 200; ++i) {
    const Vec3 first = random_point(random, 3.0);
    const Vec3 second = i % 2 == 0 ? random_point(random, 3.0) : Vec3(first + Vec3(0, 0, 1e-3));
    const auto [of_first, of_second] = numbers.at_both(first, second);
    EXPECT_NEAR(of_first, numbers.at(first), 0.01);
    EXPECT_NEAR(of_second, numbers.at(second), 0.01);
  }
  const Vec3 far = Vec3::Constant(1e200);
  EXPECT_EQ(numbers.at_both(far, {2, 0, 0})[0], 0.0);
  EXPECT_EQ(numbers.at_both(far, {2, 0, 0})[1], numbers.at({2, 0, 0}));
  EXPECT_EQ(numbers.at_both({2, 0, 0}, far)[0], numbers.at({2, 0, 0}));
}

TEST(WindingNumbers, TrianglesBackToBackDoNotCancelEachOther) {
  // Their area vectors do: what is left falls with the cube of the distance.
  std::mt19937 random(13);
  for (int i = 0; i < 100; ++i) {
    Corners t;
    for (Vec3& p : t) p = random_point(random, 1.0);
    const Corners opposite{-t[0], -t[1], -t[2]};
    // Mirroring at the origin keeps the area vector.
    const std::vector<Corners> pair{t, {opposite[0], opposite[2], opposite[1]}};
    const WindingNumbers numbers(pair);
    double worst = 0.0;
    double largest = 0.0;
    for (int k = 0; k < 50; ++k) {
      const Vec3 point = 20.0 * random_point(random, 1.0).normalized();
      const double expected = winding_by_excess(pair, point);
      largest = std::max(largest, std::abs(expected));
      worst = std::max(worst, std::abs(numbers.at(point) - expected));
    }
    EXPECT_LT(worst, 0.05 * largest + 1e-12);
  }
}

TEST(WindingNumbers, TrianglesAnywhereAreWithinTheBound) {
  std::mt19937 random(3);
  std::vector<Corners> triangles(2000);
  for (Corners& t : triangles) {
    const Vec3 middle = random_point(random, 1.0);
    for (Vec3& p : t) p = middle + random_point(random, 0.05);
  }
  const WindingNumbers numbers(triangles);
  double worst = 0.0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 point = random_point(random, 1.5);
    worst = std::max(worst, std::abs(numbers.at(point) - winding_by_excess(triangles, point)));
  }
  EXPECT_LT(worst, 0.01);
}

TEST(WindingNumbers, SizeAndPlaceAreNoMatter) {
  const Vec3 inside(0.5, 0.25, 0.5);
  const Vec3 outside(0.5, 0.25, -1.0);
  for (const double size : {1e-310, 1e-200, 1e-5, 1e150, 1e307}) {
    SCOPED_TRACE(size);
    EXPECT_NEAR(winding(shapes::cube(size), size * inside), 1.0, 1e-9);
    EXPECT_NEAR(winding(shapes::cube(size), size * outside), 0.0, 1e-9);
  }
  const Vec3 far = Vec3::Constant(1e6);
  EXPECT_NEAR(winding(shapes::cube(1.0, far), far + inside), 1.0, 1e-9);
  EXPECT_NEAR(winding(shapes::cube(3e307, Vec3::Constant(-1.5e307)), Vec3::Zero()), 1.0, 1e-9);
  EXPECT_EQ(winding(shapes::cube(1e-300), Vec3::Constant(1e300)), 0.0);
}

}  // namespace
}  // namespace meshalyzer
