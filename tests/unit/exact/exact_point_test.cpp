#include "meshalyzer/exact/exact_point.h"

#include "meshalyzer/exact/meet.h"
#include "support/rational_figures.h"
#include "unit/exact/random_points.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace meshalyzer {
namespace {

using test::Rational;
using test::RationalPoint;

RationalPoint place_of(const ExactPoint& p) {
  const Rational w(p.denominator);
  return {Rational(p.numerator[0]) / w, Rational(p.numerator[1]) / w, Rational(p.numerator[2]) / w};
}

/// Tells whether no double is nearer to x, and the rest is what is missing.
bool is_rounded_well(const Rational& x, double rounded, double rest) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const Rational error = x - Rational(rounded);
  for (const double next : {std::nextafter(rounded, kFar), std::nextafter(rounded, -kFar)}) {
    if (std::isfinite(next) && CGAL::abs(error) > CGAL::abs(x - Rational(next))) return false;
  }
  const Rational missing = CGAL::abs(error - Rational(rest));
  const Rational smallest(std::numeric_limits<double>::denorm_min());
  return (rest == 0.0) == (error == 0) &&
         missing <= CGAL::abs(error) * Rational(0x1p-50) + Rational(4) * smallest;
}

void expect_rounded_well(const ExactPoint& p) {
  const RationalPoint place = place_of(p);
  for (int k = 0; k < 3; ++k) {
    EXPECT_TRUE(is_rounded_well(place[k], p.rounded[k], p.rest[k]));
  }
}

PlanePoints next_plane(RandomPoints& points, Cloud cloud) {
  for (;;) {
    const PlanePoints plane{points.next(cloud), points.next(cloud), points.next(cloud)};
    if (!are_collinear(plane[0], plane[1], plane[2])) return plane;
  }
}

/// A line from one side of the plane to the other, if some tries find one.
std::optional<LinePoints> next_line(RandomPoints& points, Cloud cloud, const PlanePoints& plane) {
  for (int i = 0; i < 50; ++i) {
    const LinePoints line{points.next(cloud), points.next(cloud)};
    if (orient3d(plane[0], plane[1], plane[2], line[0]) *
            orient3d(plane[0], plane[1], plane[2], line[1]) <
        0) {
      return line;
    }
  }
  return std::nullopt;
}

/// Points where lines and planes meet, some of them the same.
std::vector<ExactPoint> points_made(Cloud cloud, std::size_t n) {
  RandomPoints points(5);
  std::vector<ExactPoint> made;
  while (made.size() < n) {
    const PlanePoints plane = next_plane(points, cloud);
    if (const auto line = next_line(points, cloud, plane)) made.push_back(meet(*line, plane));
    made.push_back(exact_point(points.next(cloud)));
  }
  return made;
}

TEST(Meet, OfLineAndPlaneLiesOnBoth) {
  for (const Cloud cloud : kClouds) {
    RandomPoints points(3);
    for (int i = 0; i < 30; ++i) {
      const PlanePoints plane = next_plane(points, cloud);
      const auto line = next_line(points, cloud, plane);
      if (!line) continue;
      const ExactPoint p = meet(*line, plane);
      const auto at = [](const Vec3& v) { return test::rational_point(v); };
      EXPECT_TRUE(CGAL::coplanar(at(plane[0]), at(plane[1]), at(plane[2]), place_of(p)));
      EXPECT_TRUE(CGAL::collinear(at((*line)[0]), at((*line)[1]), place_of(p)));
      EXPECT_EQ(p.denominator.sign(), CGAL::POSITIVE);
      expect_rounded_well(p);
    }
  }
}

TEST(Meet, OfThreePlanesLiesOnAll) {
  RandomPoints points(4);
  for (const Cloud cloud : {Cloud::Generic, Cloud::Lattice}) {
    for (int i = 0; i < 100; ++i) {
      const std::array<PlanePoints, 3> planes{next_plane(points, cloud), next_plane(points, cloud),
                                              next_plane(points, cloud)};
      const auto normal = [&](std::size_t k) {
        return Vec3((planes[k][1] - planes[k][0]).cross(planes[k][2] - planes[k][0]));
      };
      // Exact for whole numbers, and good enough for generic planes.
      if (normal(0).cross(normal(1)).dot(normal(2)) == 0.0) continue;
      const ExactPoint p = meet(planes[0], planes[1], planes[2]);
      for (const PlanePoints& plane : planes) {
        EXPECT_TRUE(CGAL::coplanar(test::rational_point(plane[0]), test::rational_point(plane[1]),
                                   test::rational_point(plane[2]), place_of(p)));
      }
      expect_rounded_well(p);
    }
  }
}

TEST(Meet, OfTwoLinesInOnePlaneIsWhereTheyCross) {
  const ExactPoint p = meet(LinePoints{Vec3(0, 0, 1), Vec3(3, 3, 1)},
                            LinePoints{Vec3(0, 1, 1), Vec3(1, 0, 1)}, Axis::Z);
  EXPECT_EQ(p.rounded, Vec3(0.5, 0.5, 1));
  EXPECT_TRUE(p.is_rounded());
}

TEST(Meet, HalfWayBetweenDoublesRoundsToTheEvenOne) {
  // On the line from (1, 0, 0) to (1 + 2 u, 1, 0), u the step above 1, the plane y = 3/4 is at
  // 1 + 3/2 u, and y = 1/4 at 1 + u / 2.
  constexpr double kStep = 0x1p-52;
  const LinePoints line{Vec3(1, 0, 0), Vec3(1 + 2 * kStep, 1, 0)};
  const auto at = [&](double y) {
    return meet(line, PlanePoints{Vec3(0, y, 0), Vec3(1, y, 0), Vec3(0, y, 1)}).rounded.x();
  };
  EXPECT_EQ(at(0.25), 1.0);
  EXPECT_EQ(at(0.75), 1 + 2 * kStep);
}

TEST(CompareLexicographically, EqualsTheRationals) {
  for (const Cloud cloud : kClouds) {
    const std::vector<ExactPoint> points = points_made(cloud, 40);
    for (const ExactPoint& a : points) {
      for (const ExactPoint& b : points) {
        EXPECT_EQ(compare_lexicographically(a, b),
                  static_cast<Sign>(CGAL::compare_lexicographically(place_of(a), place_of(b))));
      }
    }
  }
}

TEST(CompareLexicographically, PointsMadeInTwoWaysAreTheSame) {
  // A third of the way along the edge, by a line through a plane and by three planes.
  const PlanePoints across{Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 0, 1)};
  const ExactPoint by_line = meet(LinePoints{Vec3(0, 0, 0), Vec3(3, 1, 7)}, across);
  const ExactPoint by_planes =
      meet(PlanePoints{Vec3(0, 0, 0), Vec3(3, 1, 7), Vec3(0, 1, 0)},
           PlanePoints{Vec3(0, 0, 0), Vec3(6, 2, 14), Vec3(0, 0, 5)}, across);
  EXPECT_EQ(compare_lexicographically(by_line, by_planes), 0);
  EXPECT_EQ(by_line.rounded, by_planes.rounded);
}

TEST(Orient2dOfExactPoints, EqualsTheRationals) {
  for (const Cloud cloud : kClouds) {
    const std::vector<ExactPoint> points = points_made(cloud, 8);
    for (const ExactPoint& a : points) {
      for (const ExactPoint& b : points) {
        for (const ExactPoint& c : points) {
          const auto normal =
              CGAL::cross_product(place_of(b) - place_of(a), place_of(c) - place_of(a));
          EXPECT_EQ(orient2d(Axis::Y, a, b, c), static_cast<Sign>(CGAL::sign(normal.y())));
        }
      }
    }
  }
}

TEST(Orient3dOfExactPoints, EqualsTheRationals) {
  for (const Cloud cloud : kClouds) {
    RandomPoints points(6);
    const std::vector<ExactPoint> made = points_made(cloud, 12);
    for (int i = 0; i < 8; ++i) {
      const Vec3 a = points.next(cloud);
      const Vec3 b = points.next(cloud);
      const Vec3 c = points.next(cloud);
      for (const ExactPoint& d : made) {
        const auto expected = CGAL::orientation(test::rational_point(a), test::rational_point(b),
                                                test::rational_point(c), place_of(d));
        EXPECT_EQ(orient3d(a, b, c, d), static_cast<Sign>(expected));
      }
    }
  }
}

TEST(Orient3dOfExactPoints, PointMadeInAPlaneIsInIt) {
  for (const Cloud cloud : kClouds) {
    RandomPoints points(7);
    for (int i = 0; i < 20; ++i) {
      const PlanePoints plane = next_plane(points, cloud);
      const auto line = next_line(points, cloud, plane);
      if (!line) continue;
      EXPECT_EQ(orient3d(plane[0], plane[1], plane[2], meet(*line, plane)), 0);
    }
  }
}

TEST(ExactPoint, PointOnALineToAPointFarOutIsOnItThoughItsRestIsTiny) {
  // The line falls by some 1e-310 where the plane cuts it, which has fewer digits than a double.
  const Vec3 near(-3.455246, 3.800894, 0.732667);
  const Vec3 far(1e308, 3.784864, 0.661381);
  for (const double x : {-3.06, -2.0, 0.5, 7.0}) {
    const ExactPoint point = meet(LinePoints{near, far}, {Vec3(x, 0, 0), {x, 1, 0}, {x, 0, 1}});
    EXPECT_LT(std::abs(point.rest.y()), 1e-307);
    EXPECT_EQ(orient2d(Axis::Y, exact_point(near), exact_point(far), point), 0);
    EXPECT_EQ(orient2d(Axis::Z, exact_point(near), exact_point(far), point), 0);
  }
}

}  // namespace
}  // namespace meshalyzer
