#include "meshalyzer/spatial/triangle_distance.h"

#include "support/distance_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace meshalyzer {
namespace {

/// The half square with legs of length 2 in the plane z = 0.
const Corners kHalfSquare{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)};

void expect_closest(const Vec3& p, const Vec3& point) {
  const TrianglePoint closest = closest_on_triangle(kHalfSquare, p);
  EXPECT_NEAR((closest.point - point).norm(), 0.0, 1e-15) << p.transpose();
  EXPECT_NEAR(closest.distance, (p - point).norm(), 1e-15) << p.transpose();
}

/// The distance is true, and it is that of a point of the triangle; both but for an error.
void expect_true(const Corners& t, const Vec3& p, double error) {
  const TrianglePoint closest = closest_on_triangle(t, p);
  EXPECT_TRUE(test::is_rational_distance(closest.distance, t, p, error)) << p.transpose();
  EXPECT_TRUE(test::is_rational_distance(0.0, t, closest.point, error)) << p.transpose();
  EXPECT_NEAR((closest.point - p).norm(), closest.distance, error) << p.transpose();
}

class RandomTriangles {
 public:
  double real() { return real_(engine_); }
  Vec3 vector() { return {real(), real(), real()}; }
  Corners triangle() { return {vector(), vector(), vector()}; }

 private:
  std::mt19937 engine_{11};
  std::uniform_real_distribution<> real_{-1.0, 1.0};
};

TEST(ClosestOnTriangle, FaceEdgesAndCornersEachHaveTheirRegion) {
  expect_closest({0.5, 0.5, 3}, {0.5, 0.5, 0});
  expect_closest({0.5, 0.5, -3}, {0.5, 0.5, 0});
  expect_closest({1, -2, 1}, {1, 0, 0});
  expect_closest({-2, 0.5, 1}, {0, 0.5, 0});
  expect_closest({2, 2, 1}, {1, 1, 0});
  expect_closest({-1, -2, 1}, {0, 0, 0});
  expect_closest({5, -1, 1}, {2, 0, 0});
  expect_closest({-1, 5, 1}, {0, 2, 0});
}

TEST(ClosestOnTriangle, PointsOfTheTriangleAreAtNoDistance) {
  RandomTriangles random;
  for (int i = 0; i < 1000; ++i) {
    const Corners t = random.triangle();
    for (const Vec3& corner : t) {
      EXPECT_EQ(closest_on_triangle(t, corner).distance, 0.0);
      EXPECT_EQ(closest_on_triangle(t, corner).point, corner);
    }
  }
  // Points whose coordinates, and those of their differences, are short binary fractions.
  for (const Vec3& p : {Vec3(0.5, 0, 0), Vec3(0, 1.75, 0), Vec3(1.25, 0.75, 0), Vec3(1, 0.5, 0)}) {
    EXPECT_EQ(closest_on_triangle(kHalfSquare, p).distance, 0.0);
    EXPECT_EQ(closest_on_triangle(kHalfSquare, p).point, p);
  }
}

TEST(ClosestOnTriangle, RandomTrianglesAgreeWithTheRationals) {
  RandomTriangles random;
  for (int i = 0; i < 3000; ++i) {
    const Corners t = random.triangle();
    const Vec3 p = 2 * random.vector();
    const double distance = closest_on_triangle(t, p).distance;
    EXPECT_TRUE(test::is_rational_distance(distance, t, p, 1e-13 * distance)) << i;
    expect_true(t, p, 4e-15);
  }
}

TEST(ClosestOnTriangle, SliversOfAnyWidthAgreeWithTheRationals) {
  RandomTriangles random;
  for (int i = 0; i < 4000; ++i) {
    // The third corner near a point of the line of the other two: beyond the end, near it, between.
    const double width = std::pow(10.0, -1 - i % 20);
    Corners t = random.triangle();
    const double share = i % 3 == 0 ? 1.0 : random.real();
    t[2] = t[0] + share * (t[1] - t[0]) + width * random.vector();
    std::rotate(t.begin(), t.begin() + i % 2, t.end());
    // A point at about the same distance, where it matters which of face and edges is closest.
    const Vec3 p = t[0] + 0.4 * (t[1] - t[0]) + (i % 5 == 0 ? 1.0 : 3 * width) * random.vector();
    expect_true(t, p, 4e-15);
  }
}

TEST(ClosestOnTriangle, PointFarAwayHasItsClosestPointOnTheTriangle) {
  RandomTriangles random;
  for (const double far : {1e3, 1e8, 1e15, 1e30}) {
    for (int i = 0; i < 50; ++i) {
      // Well shaped, and seen along the normal or from anywhere.
      const Vec3 apex(0, 0, 1 + 0.1 * random.real());
      const Corners t{Vec3(1, 0.1 * random.real(), 0), Vec3(0, 1, 0.1 * random.real()), apex};
      const Vec3 middle = (t[0] + t[1] + t[2]) / 3;
      const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
      const Vec3 p = i % 2 == 0 ? Vec3(middle + far * normal) : Vec3(far * random.vector());
      const TrianglePoint closest = closest_on_triangle(t, p);
      EXPECT_TRUE(test::is_rational_distance(closest.distance, t, p, 1e-15 * far));
      EXPECT_TRUE(test::is_rational_distance(0.0, t, closest.point, 2e-15));
      if (i % 2 == 0) {
        EXPECT_LE((closest.point - middle).norm(), 2e-15 * far);
      }
    }
  }
}

TEST(ClosestOnTriangle, ZeroAreaIsTheSegmentOrPointThatItIs) {
  const Vec3 a(1, 1, 1);
  const Vec3 b(3, 3, 3);
  const Vec3 middle(2, 2, 2);
  for (const Corners& t : {Corners{a, middle, b}, Corners{b, a, middle}, Corners{a, b, a}}) {
    // (4, 0, 2) is seen from the middle of the line at a right angle.
    EXPECT_NEAR((closest_on_triangle(t, {4, 0, 2}).point - middle).norm(), 0.0, 1e-15);
    EXPECT_NEAR(closest_on_triangle(t, {4, 0, 2}).distance, std::numbers::sqrt2 * 2, 1e-15);
    EXPECT_EQ(closest_on_triangle(t, {0, 0, 0}).point, a);
  }
  EXPECT_EQ(closest_on_triangle({a, a, a}, {1, 1, 3}).distance, 2.0);
  EXPECT_EQ(closest_on_triangle({a, a, a}, a).distance, 0.0);
}

TEST(ClosestOnTriangle, ScalingByAPowerOfTwoScalesTheAnswerToTheBit) {
  RandomTriangles random;
  for (const int exponent : {-1000, -600, -200, 200, 600, 1000}) {
    const Corners t = random.triangle();
    const Vec3 p = random.vector();
    const double factor = std::ldexp(1.0, exponent);
    const TrianglePoint there =
        closest_on_triangle({t[0] * factor, t[1] * factor, t[2] * factor}, p * factor);
    EXPECT_EQ(there.distance, closest_on_triangle(t, p).distance * factor);
    EXPECT_EQ(there.point, closest_on_triangle(t, p).point * factor);
  }
}

TEST(ClosestOnTriangle, LargestAndSmallestNumbersGiveNumbers) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
  const Corners large{Vec3(kLargest, 0, 0), Vec3(0, kLargest, 0), Vec3(0, 0, kLargest)};
  // From the corner of a cube to the plane through three others: side / sqrt 3.
  EXPECT_NEAR(closest_on_triangle(large, {0, 0, 0}).distance / kLargest, 1 / std::numbers::sqrt3,
              1e-15);
  // Farther than any number: 2 and more times the largest.
  const TrianglePoint beyond = closest_on_triangle(large, Vec3(-kLargest, -kLargest, -kLargest));
  EXPECT_EQ(beyond.distance, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(beyond.point.hasNaN());
  const Corners small{Vec3(kSmallest, 0, 0), Vec3(kSmallest, 4 * kSmallest, 0),
                      Vec3(kSmallest, 0, 4 * kSmallest)};
  EXPECT_EQ(closest_on_triangle(small, {4 * kSmallest, kSmallest, kSmallest}).distance,
            3 * kSmallest);
}

TEST(ClosestOnTriangle, OrderOfTheCornersDoesNotMatter) {
  RandomTriangles random;
  for (int i = 0; i < 200; ++i) {
    const Corners t = random.triangle();
    const Vec3 p = random.vector();
    const double distance = closest_on_triangle(t, p).distance;
    EXPECT_NEAR(closest_on_triangle({t[1], t[2], t[0]}, p).distance, distance, 4e-16);
    EXPECT_NEAR(closest_on_triangle({t[2], t[1], t[0]}, p).distance, distance, 4e-16);
  }
}

Cone cone(const Vec3& axis, double half_angle_degrees) {
  return {axis.normalized(), std::cos(half_angle_degrees * std::numbers::pi / 180)};
}

/// Wide enough to be the plane z = 1 for all cones below.
const Corners kPlane{Vec3(-1e3, -1e3, 1), Vec3(1e3, -1e3, 1), Vec3(0, 1e3, 1)};

TEST(ClosestOnTriangleInCone, FootInTheConeIsTheAnswer) {
  const auto closest = closest_on_triangle(kPlane, Vec3::Zero(), cone({0.1, 0, 1}, 30));
  ASSERT_TRUE(closest);
  EXPECT_NEAR((closest->point - Vec3(0, 0, 1)).norm(), 0.0, 1e-12);
}

TEST(ClosestOnTriangleInCone, PlaneIsMetAtTheSideNearestToItsNormal) {
  // The axis leans by 50 degrees, the side by 50 - 20 = 30.
  const double lean = 50 * std::numbers::pi / 180;
  const auto closest =
      closest_on_triangle(kPlane, Vec3::Zero(), cone({std::sin(lean), 0, std::cos(lean)}, 20));
  ASSERT_TRUE(closest);
  EXPECT_NEAR(closest->distance, 2 / std::numbers::sqrt3, 1e-12);
  EXPECT_NEAR((closest->point - Vec3(1 / std::numbers::sqrt3, 0, 1)).norm(), 0.0, 1e-12);
}

TEST(ClosestOnTriangleInCone, ConeLeaningAwayMeetsNothing) {
  EXPECT_FALSE(closest_on_triangle(kPlane, Vec3::Zero(), cone({0, 0, -1}, 60)));
  EXPECT_FALSE(closest_on_triangle(kPlane, Vec3::Zero(), cone({1, 0, -0.5}, 20)));
}

TEST(ClosestOnTriangleInCone, EdgeIsCutWhereTheConeEnds) {
  // A wall at x = 1 ... 2 seen at 45 degrees from the axis z: its edge on x = 1 enters at z = 1.
  const Corners wall{Vec3(1, 0, -5), Vec3(1, 0, 5), Vec3(2, 0, 0)};
  const auto closest = closest_on_triangle(wall, Vec3::Zero(), cone({0, 0, 1}, 45));
  ASSERT_TRUE(closest);
  EXPECT_NEAR((closest->point - Vec3(1, 0, 1)).norm(), 0.0, 1e-14);
  EXPECT_NEAR(closest->distance, std::numbers::sqrt2, 1e-14);
}

TEST(ClosestOnTriangleInCone, HalfSpaceIsACone) {
  // The nearest point (1, 0, -1) lies behind; on the edge x = 1 the half-space begins at z = 0.
  const Corners wall{Vec3(1, 0, -2), Vec3(1, 0, 3), Vec3(9, 0, 1)};
  const auto closest = closest_on_triangle(wall, Vec3(0, 0, -1), Cone{Vec3(0, 0, 1), 0.0});
  ASSERT_TRUE(closest);
  EXPECT_EQ(closest->point, Vec3(1, 0, -1));
  const auto ahead = closest_on_triangle(wall, Vec3(0, 0, 1), Cone{Vec3(-0.6, 0, 0.8), 0.0});
  // -0.6 x + 0.8 z = 0 at x = 1 for z = 0.75 above the apex, which is nearer than any further on.
  ASSERT_TRUE(ahead);
  EXPECT_NEAR((ahead->point - Vec3(1, 0, 1.75)).norm(), 0.0, 1e-15);
}

TEST(ClosestOnTriangleInCone, MirroredHalfOfTheConeDoesNotCount) {
  const Corners behind{Vec3(-1, -1, -2), Vec3(1, -1, -2), Vec3(0, 2, -2)};
  EXPECT_FALSE(closest_on_triangle(behind, Vec3::Zero(), cone({0, 0, 1}, 10)));
  // An edge that runs through both halves is met in the right one.
  const Corners through{Vec3(0.1, 0, -3), Vec3(0.1, 0, 3), Vec3(50, 0, 0)};
  const auto closest = closest_on_triangle(through, Vec3::Zero(), cone({0, 0, 1}, 45));
  ASSERT_TRUE(closest);
  EXPECT_NEAR((closest->point - Vec3(0.1, 0, 0.1)).norm(), 0.0, 1e-15);
}

TEST(ClosestOnTriangleInCone, ApexOnTheTriangleIsInTheCone) {
  for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(-1, -1, 0)}) {
    for (const Vec3& p : {Vec3(0.5, 0.5, 0), Vec3(0, 0, 0), Vec3(1, 0, 0)}) {
      const auto closest = closest_on_triangle(kHalfSquare, p, cone(axis, 15));
      ASSERT_TRUE(closest);
      EXPECT_EQ(closest->distance, 0.0);
      EXPECT_EQ(closest->point, p);
    }
  }
}

TEST(ClosestOnTriangleInCone, AnySizeHasTheSameAnswer) {
  const Cone side = cone({1, 0, 1}, 30);
  const auto here = closest_on_triangle(kPlane, Vec3::Zero(), side);
  ASSERT_TRUE(here);
  for (const int exponent : {-1000, 1000}) {
    const double factor = std::ldexp(1.0, exponent);
    const auto there = closest_on_triangle(
        {kPlane[0] * factor, kPlane[1] * factor, kPlane[2] * factor}, Vec3::Zero(), side);
    ASSERT_TRUE(there);
    EXPECT_EQ(there->distance, here->distance * factor);
  }
}

/// Calls `visit` for the points of a triangle that have shares in n-ths of its corners.
template <typename Visit>
void sample(const Corners& t, int n, Visit visit) {
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; i + j <= n; ++j) {
      visit(Vec3((i * t[0] + j * t[1] + (n - i - j) * t[2]) / n));
    }
  }
}

TEST(ClosestOnTriangleInCone, NoSampleInTheConeIsNearer) {
  RandomTriangles random;
  int n_found = 0;
  int n_missed = 0;
  for (int i = 0; i < 1500; ++i) {
    Corners t = random.triangle();
    if (i % 4 == 0) t[2] = t[0] + random.real() * (t[1] - t[0]) + 1e-4 * random.vector();
    const Vec3 p = random.vector();
    const Cone c = cone(random.vector(), 45 + 44 * random.real());
    const auto closest = closest_on_triangle(t, p, c);
    const auto excess = [&](const Vec3& x) {
      return (x - p).dot(c.axis) - c.cos_half_angle * (x - p).norm();
    };
    if (closest) {
      EXPECT_GE(excess(closest->point), -1e-8) << i;
      EXPECT_TRUE(test::is_rational_distance(0.0, t, closest->point, 1e-14)) << i;
      EXPECT_NEAR((closest->point - p).norm(), closest->distance, 1e-14) << i;
    }
    const double nearest = closest ? closest->distance : std::numeric_limits<double>::infinity();
    sample(t, 60, [&](const Vec3& x) {
      if (excess(x) > 1e-9) {
        EXPECT_LE(nearest, (x - p).norm() + 1e-14) << i;
      }
    });
    ++(closest ? n_found : n_missed);
  }
  EXPECT_GT(n_found, 300);
  EXPECT_GT(n_missed, 300);
}

}  // namespace
}  // namespace meshalyzer
