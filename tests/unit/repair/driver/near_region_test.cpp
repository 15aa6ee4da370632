#include "meshalyzer/repair/driver/internal/near_region.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/triangle_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace meshalyzer::test {
namespace {

/// A triangle of the plane z = 0 that is wide enough for all that these tests do.
const Corners kWide{Vec3(-40, -40, 0), Vec3(80, -40, 0), Vec3(-40, 80, 0)};
const FacePlane kPlane{Vec3::Zero(), Vec3::UnitZ()};

ConvexPiece cut_at_all(ConvexPiece piece, const std::vector<HalfSpace>& bounds) {
  for (const HalfSpace& bound : bounds) piece = piece.cut(bound).inside;
  return piece;
}

/// Returns the place below a point, and what of the triangle is closest to it.
PlaceNearTriangle seen_from(const Vec3& point, const Corners& t) {
  const Vec3 place(point.x(), point.y(), 0.0);
  return {place, closest_on_triangle(t, place).point};
}

double area_of(const Corners& t) {
  return normal_of(t).norm() / 2;
}

class Random {
 public:
  double between(double low, double high) {
    return std::uniform_real_distribution(low, high)(engine_);
  }
  Vec3 point(double half) {
    return {between(-half, half), between(-half, half), between(-half, half)};
  }

 private:
  std::mt19937 engine_{20260};
};

TEST(ConvexPiece, PartsLieOnTheirSidesAndHaveTheWholeArea) {
  Random random;
  for (int run = 0; run < 500; ++run) {
    ConvexPiece piece({random.point(2), random.point(2), random.point(2)});
    // Cut further and further, so that pieces with many corners are among them.
    for (int cut = 0; cut < 6; ++cut) {
      const HalfSpace half{piece.middle() + random.point(0.1), random.point(1).normalized(),
                           random.between(-0.1, 0.1)};
      const auto [inside, outside] = piece.cut(half);
      for (const Vec3& corner : inside.corners()) EXPECT_LE(half.excess(corner), 1e-14);
      for (const Vec3& corner : outside.corners()) EXPECT_GE(half.excess(corner), -1e-14);
      EXPECT_NEAR(inside.area(1) + outside.area(1), piece.area(1), 1e-14);
      piece = inside.area(1) > outside.area(1) ? inside : outside;
    }
  }
}

TEST(ConvexPiece, IsWholeOnOneSideOfAPlaneThatItOnlyTouches) {
  const ConvexPiece piece({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
  const auto [inside, outside] = piece.cut({Vec3(0, 0, 0), Vec3(-1, 0, 0), 0.0});
  EXPECT_EQ(inside.corners().size(), 3);
  EXPECT_TRUE(outside.empty());
}

TEST(ConvexPiece, IsCutInTwoBetweenOppositeCorners) {
  const ConvexPiece square = cut_at_all(ConvexPiece(kWide), {{Vec3::Zero(), Vec3(1, 0, 0), 1},
                                                             {Vec3::Zero(), Vec3(0, 1, 0), 1},
                                                             {Vec3::Zero(), Vec3(-1, 0, 0), 1},
                                                             {Vec3::Zero(), Vec3(0, -1, 0), 1}});
  ASSERT_EQ(square.corners().size(), 4);
  const auto [half, other] = square.cut_between_corners();
  EXPECT_NEAR(half.area(1), 2, 1e-14);
  EXPECT_NEAR(other.area(1), 2, 1e-14);
  EXPECT_NEAR((half.diameter()[1] - half.diameter()[0]).norm(), std::sqrt(8), 1e-14);
}

TEST(ConvexPiece, PartsInTheBoxesRoundAPointAddUpToTheWhole) {
  Random random;
  for (int run = 0; run < 500; ++run) {
    const ConvexPiece piece({random.point(2), random.point(2), random.point(2)});
    const Vec3 place = random.point(1);
    double area = 0.0;
    for (int side = 0; side < 8; ++side) {
      Box3 box(place);
      box.extend(Vec3(side % 2 == 0 ? -2 : 2, side / 2 % 2 == 0 ? -2 : 2, side < 4 ? -2 : 2));
      const ConvexPiece part = piece.part_in(box);
      for (const Vec3& corner : part.corners()) EXPECT_LE(box.exteriorDistance(corner), 1e-14);
      area += part.area(1);
    }
    EXPECT_NEAR(area, piece.area(1), 1e-13);
  }
}

TEST(ConvexPiece, HasNoPartInABoxBesideIt) {
  const ConvexPiece piece({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
  EXPECT_TRUE(piece.part_in(Box3(Vec3(0.6, 0.6, -1), Vec3(1, 1, 1))).empty());
}

TEST(NearRegion, OfATriangleInThePlaneIsGrownByTheDistanceExceptAtCorners) {
  Random random;
  for (int run = 0; run < 200; ++run) {
    Corners t{random.point(3), random.point(3), random.point(3)};
    for (Vec3& corner : t) corner.z() = 0.0;
    const double distance = random.between(0.01, 2);
    const ConvexPiece region = cut_at_all(
        ConvexPiece(kWide), find_near_region(t, kPlane, distance, seen_from(centroid_of(t), t)));
    // A strip along each side, and at each corner the triangle between the ends of two strips.
    double expected = area_of(t);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 to_next = t[(i + 1) % 3] - t[i];
      const Vec3 to_last = t[(i + 2) % 3] - t[i];
      const double sine = to_next.cross(to_last).norm() / (to_next.norm() * to_last.norm());
      expected += to_next.norm() * distance + distance * distance * sine / 2;
    }
    EXPECT_NEAR(region.area(1), expected, 1e-11 * expected);
  }
}

TEST(NearRegion, AboveTheTriangleIsGrownByWhatTheHeightLeaves) {
  // 3, 4, 5: a triangle 3 below the plane is within 5 of what lies within 4 of its projection.
  const Corners t{Vec3(0, 0, -3), Vec3(6, 0, -3), Vec3(0, 8, -3)};
  const ConvexPiece region =
      cut_at_all(ConvexPiece(kWide), find_near_region(t, kPlane, 5, seen_from(centroid_of(t), t)));
  EXPECT_NEAR(region.area(1), 24 + 24 * 4 + 16 * (1 + 0.8 + 0.6) / 2, 1e-12);
}

TEST(NearRegion, ReachesToAPlaceOutsideOfACorner) {
  // Within the disc round the origin, beyond the line between the ends of the sides' strips.
  const Corners t{Vec3(0, 0, 0), Vec3(6, 0, 0), Vec3(0, 8, 0)};
  const Vec3 place(-0.6, -0.79, 0);
  const std::vector<HalfSpace> bounds = find_near_region(t, kPlane, 1, seen_from(place, t));
  for (const HalfSpace& bound : bounds) EXPECT_LE(bound.excess(place), 0);
  const ConvexPiece region = cut_at_all(ConvexPiece(kWide), bounds);
  EXPECT_EQ(bounds.size(), 7);
  // Two triangles at the origin, between the tip and the ends of the strips.
  const Vec3 tip = place.normalized();
  EXPECT_NEAR(region.area(1), 24 + 24 + (0.8 + 0.6) / 2 - (tip.x() + tip.y()) / 2, 1e-12);
}

TEST(NearRegion, IsWithinTheDistanceAndHoldsThePlace) {
  Random random;
  for (int run = 0; run < 3000; ++run) {
    // Some of them are in the plane, some stand upright, some are segments.
    Corners t{random.point(3), random.point(3), random.point(3)};
    if (run % 4 == 1) t[2] = t[0] + Vec3(0, 0, random.between(0.5, 3));
    if (run % 4 == 2) t[2] = (t[0] + t[1]) / 2;
    if (run % 4 == 3) t[0].z() = t[1].z() = t[2].z() = 0.0;
    const double distance = random.between(0.1, 2);
    const PlaceNearTriangle from = seen_from(random.point(4), t);
    if ((from.place - from.closest).norm() >= 0.99 * distance) continue;
    const std::vector<HalfSpace> bounds = find_near_region(t, kPlane, distance, from);
    ASSERT_FALSE(bounds.empty());
    ASSERT_LE(bounds.size(), 11);
    for (const HalfSpace& bound : bounds) {
      EXPECT_NEAR(bound.outward.norm(), 1, 1e-12);
      EXPECT_LE(bound.excess(from.place), 1e-9) << run;
    }
    const ConvexPiece region = cut_at_all(ConvexPiece(kWide), bounds);
    // The distance from a triangle is convex, so that it is largest at corners.
    for (const Vec3& corner : region.corners()) {
      EXPECT_LE(closest_on_triangle(t, corner).distance, distance + 1e-9) << run;
    }
  }
}

}  // namespace
}  // namespace meshalyzer::test
