#include "meshalyzer/picture/internal/contact_segments.h"

#include "meshalyzer/spatial/triangle_distance.h"
#include "support/random_soups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace meshalyzer {
namespace {

using Segment = std::array<Vec3, 2>;

std::vector<Segment> contact(const Corners& p, const Corners& q, ContactKind kind) {
  const ContactSegments found = contact_segments(p, q, kind);
  return {found.begin(), found.end()};
}

Corners scaled(const Corners& t, double factor) {
  return {t[0] * factor, t[1] * factor, t[2] * factor};
}

/// Tells whether a segment has these ends, in whatever order, but for rounding.
void expect_ends(const Segment& segment, const Vec3& a, const Vec3& b, double error = 1e-9) {
  const bool turned = (segment[0] - a).norm() > (segment[1] - a).norm();
  EXPECT_LE((segment[turned ? 1 : 0] - a).norm(), error) << segment[0] << "\n" << segment[1];
  EXPECT_LE((segment[turned ? 0 : 1] - b).norm(), error) << segment[0] << "\n" << segment[1];
}

/// The largest distance of an end of the segments from either triangle.
double distance_from_both(std::span<const Segment> segments, const Corners& p, const Corners& q) {
  double distance = 0.0;
  for (const Segment& segment : segments) {
    for (const Vec3& end : segment) {
      distance = std::max(
          {distance, closest_on_triangle(p, end).distance, closest_on_triangle(q, end).distance});
    }
  }
  return distance;
}

Vec3 random_corner(std::mt19937& random) {
  const auto number = [&] { return static_cast<double>(below(random, 9)) - 4.0; };
  const double x = number();
  const double y = number();
  return {x, y, number()};
}

Corners random_triangle(std::mt19937& random) {
  const Vec3 a = random_corner(random);
  const Vec3 b = random_corner(random);
  return {a, b, random_corner(random)};
}

Vec3 normal_of(const Corners& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]);
}

/// Where the edges of p pierce q. Corners are small whole numbers, so that all determinants are
/// exact; edges in q's plane are left to the others.
void add_piercings(const Corners& p, const Corners& q, std::vector<Vec3>& points) {
  const Vec3 n = normal_of(q);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = p[i];
    const Vec3& b = p[(i + 1) % 3];
    const double height_a = n.dot(a - q[0]);
    const double height_b = n.dot(b - q[0]);
    if (height_a * height_b > 0 || height_a == height_b) continue;
    const double weight = std::abs(height_a) + std::abs(height_b);
    // The point in homogeneous coordinates, of this weight.
    const Vec3 x = std::abs(height_b) * a + std::abs(height_a) * b;
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 along = q[(k + 1) % 3] - q[k];
      inside = inside && n.dot(along.cross(x - weight * q[k])) >= 0;
    }
    if (inside) points.push_back(x / weight);
  }
}

/// The two of some points that are farthest apart.
Segment extremes(std::span<const Vec3> points) {
  Segment extremes{points[0], points[0]};
  for (const Vec3& a : points) {
    for (const Vec3& b : points) {
      if ((b - a).norm() > (extremes[1] - extremes[0]).norm()) extremes = {a, b};
    }
  }
  return extremes;
}

TEST(ContactSegments, CrossingTrianglesMeetWhereTheirEdgesPierceTheOther) {
  std::mt19937 random(7);
  std::size_t n_met = 0;
  for (int i = 0; i < 20000; ++i) {
    const Corners p = random_triangle(random);
    const Corners q = random_triangle(random);
    const std::optional<ContactKind> kind = find_contact(p, q, Common::Nothing);
    const bool in_planes = !normal_of(p).cross(normal_of(q)).isZero(0.0);
    if (!kind || !in_planes) continue;
    std::vector<Vec3> points;
    add_piercings(p, q, points);
    add_piercings(q, p, points);
    ASSERT_FALSE(points.empty());
    const auto [a, b] = extremes(points);
    const std::vector<Segment> found = contact(p, q, *kind);
    ASSERT_EQ(found.size(), 1U);
    // What is within the tolerance of both planes reaches farther where these are nearly parallel:
    // by 1 / sine of their angle, at least 1 / (128^2 3) here.
    expect_ends(found[0], a, b, 1e-6);
    EXPECT_LE(distance_from_both(found, p, q), 4e-9);
    ++n_met;
  }
  EXPECT_GT(n_met, 1000U);
}

/// Twice the area that the border of `p`, as far as it lies in `q`, adds to the overlap of two
/// triangles that run counter-clockwise (Green's theorem).
double share_of_overlap(std::span<const Eigen::Vector2d> p, std::span<const Eigen::Vector2d> q) {
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector2d a = p[i];
    const Eigen::Vector2d along = p[(i + 1) % 3] - a;
    double first = 0.0;
    double last = 1.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector2d side = q[(k + 1) % 3] - q[k];
      const double at_a = cross(side, a - q[k]);
      const double slope = cross(side, along);
      if (slope > 0) first = std::max(first, -at_a / slope);
      if (slope < 0) last = std::min(last, -at_a / slope);
      if (slope == 0 && at_a < 0) last = first;
    }
    if (first < last) sum += cross(a + first * along, a + last * along);
  }
  return sum;
}

TEST(ContactSegments, CoplanarTrianglesHaveTheOutlineOfTheirOverlap) {
  std::mt19937 random(11);
  // The plane z = x + 2 y, of normal (-1, -2, 1): areas are sqrt(6) times those seen from above.
  const auto raised = [](const Eigen::Vector2d& p) {
    return Vec3(p.x(), p.y(), p.x() + 2 * p.y());
  };
  std::size_t n_met = 0;
  for (int i = 0; i < 5000; ++i) {
    std::array<Eigen::Vector2d, 6> flat;
    for (Eigen::Vector2d& p : flat) p = random_corner(random).head<2>();
    Corners p{raised(flat[0]), raised(flat[1]), raised(flat[2])};
    Corners q{raised(flat[3]), raised(flat[4]), raised(flat[5])};
    if (find_contact(p, q, Common::Nothing) != ContactKind::CoplanarOverlap) continue;
    for (const std::size_t first : {0U, 3U}) {
      const Eigen::Vector2d u = flat[first + 1] - flat[first];
      const Eigen::Vector2d v = flat[first + 2] - flat[first];
      if (u.x() * v.y() < u.y() * v.x()) std::swap(flat[first + 1], flat[first + 2]);
    }
    // Edges on one line would count twice: one triangle is shrunk a little about its middle.
    const Eigen::Vector2d middle = (flat[3] + flat[4] + flat[5]) / 3;
    for (std::size_t k = 3; k < 6; ++k) flat[k] += (middle - flat[k]) * 0.0123;
    q = {raised(flat[3]), raised(flat[4]), raised(flat[5])};
    const std::span corners(flat);
    const double wanted = (share_of_overlap(corners.first(3), corners.last(3)) +
                           share_of_overlap(corners.last(3), corners.first(3))) /
                          2;
    if (wanted < 1e-3) continue;
    const std::vector<Segment> outline = contact(p, q, ContactKind::CoplanarOverlap);
    Vec3 twice_area = Vec3::Zero();
    for (std::size_t k = 0; k < outline.size(); ++k) {
      EXPECT_LE((outline[k][1] - outline[(k + 1) % outline.size()][0]).norm(), 1e-8);
      twice_area += outline[k][0].cross(outline[k][1]);
    }
    EXPECT_NEAR(twice_area.norm() / 2, wanted * std::sqrt(6.0), 1e-8);
    EXPECT_LE(distance_from_both(outline, p, q), 1e-8);
    ++n_met;
  }
  EXPECT_GT(n_met, 500U);
}

const Corners kFlat{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

TEST(ContactSegments, CornerOnAFaceIsAPoint) {
  const Corners tip{Vec3(1, 1, 0), Vec3(1, 0, 2), Vec3(2, 1, 2)};
  for (const auto& found :
       {contact(kFlat, tip, ContactKind::Touching), contact(tip, kFlat, ContactKind::Touching)}) {
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0][0], found[0][1]);
    expect_ends(found[0], Vec3(1, 1, 0), Vec3(1, 1, 0));
  }
}

TEST(ContactSegments, EdgeInAFaceIsThatEdge) {
  const Corners standing{Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 1, 5)};
  const auto found = contact(kFlat, standing, ContactKind::Touching);
  ASSERT_EQ(found.size(), 1U);
  expect_ends(found[0], Vec3(1, 1, 0), Vec3(2, 1, 0));
}

TEST(ContactSegments, DuplicateHasItsOwnOutline) {
  const auto found = contact(kFlat, kFlat, ContactKind::Duplicate);
  ASSERT_EQ(found.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) expect_ends(found[i], kFlat[i], kFlat[(i + 1) % 3]);
}

TEST(ContactSegments, SegmentsAndPointsAreTrianglesToo) {
  // Zero-area triangles: through the face, in it and beyond its border, and one that is a point.
  const Corners needle{Vec3(1, 1, -1), Vec3(1, 1, 0), Vec3(1, 1, 3)};
  const Corners lying{Vec3(-1, 1, 0), Vec3(2, 1, 0), Vec3(0, 1, 0)};
  const Corners dot{Vec3(1, 2, 0), Vec3(1, 2, 0), Vec3(1, 2, 0)};
  expect_ends(contact(needle, kFlat, ContactKind::Touching)[0], Vec3(1, 1, 0), Vec3(1, 1, 0));
  expect_ends(contact(kFlat, needle, ContactKind::Touching)[0], Vec3(1, 1, 0), Vec3(1, 1, 0));
  expect_ends(contact(lying, kFlat, ContactKind::Touching)[0], Vec3(0, 1, 0), Vec3(2, 1, 0));
  expect_ends(contact(kFlat, dot, ContactKind::Touching)[0], dot[0], dot[0]);
}

TEST(ContactSegments, TwoSegmentsMeetInAPointOrAlongALine) {
  const Corners x_axis{Vec3(-1, 0, 0), Vec3(0, 0, 0), Vec3(3, 0, 0)};
  const Corners y_axis{Vec3(0.5, -1, 0), Vec3(0.5, 2, 0), Vec3(0.5, 2, 0)};
  const Corners longer{Vec3(1, 0, 0), Vec3(7, 0, 0), Vec3(5, 0, 0)};
  expect_ends(contact(x_axis, y_axis, ContactKind::Touching)[0], Vec3(0.5, 0, 0), Vec3(0.5, 0, 0));
  expect_ends(contact(x_axis, longer, ContactKind::Touching)[0], Vec3(1, 0, 0), Vec3(3, 0, 0));
}

TEST(ContactSegments, SegmentsThatCrossAtASmallAngleMeetInAPoint) {
  // Through (0.5, 0, 0), a third of the way; the other on either side of it.
  const Corners along{Vec3(-1, 0, 0), Vec3(0, 0, 0), Vec3(3.5, 0, 0)};
  const Vec3 place(0.5, 0, 0);
  for (const double slope : {0.5, 1e-2, 1e-4}) {
    const Vec3 direction(1, slope, -slope);
    const Corners across{place - direction, place + 2 * direction, place + 2 * direction};
    for (const auto& found : {contact(along, across, ContactKind::Touching),
                              contact(across, along, ContactKind::Touching)}) {
      ASSERT_EQ(found.size(), 1U);
      expect_ends(found[0], place, place, 1e-11 / slope);
      EXPECT_LE(distance_from_both(found, along, across), 4e-9);
    }
  }
}

TEST(ContactSegments, SegmentInTheFaceBehindItIsCutByItsBorder) {
  // It is the second of the pair, so that only the first has a plane; both ends are off the face.
  const Corners lying{Vec3(-1, 1, 0), Vec3(5, 1, 0), Vec3(0, 1, 0)};
  expect_ends(contact(kFlat, lying, ContactKind::Touching)[0], Vec3(0, 1, 0), Vec3(3, 1, 0));
  expect_ends(contact(lying, kFlat, ContactKind::Touching)[0], Vec3(0, 1, 0), Vec3(3, 1, 0));
}

TEST(ContactSegments, SizeOfThePairDoesNotMatter) {
  const Corners standing{Vec3(1, 1, -1), Vec3(1, 1, 2), Vec3(1, -3, -1)};
  // In the plane x = 1 the face reaches from y = 0, the other one to the line from (1, -1) to
  // (-3, -1) at z = 0: y = 1.
  for (const double size : {1.0, 0x1p-1000, 0x1p-300, 0x1p300, 0x1p1020}) {
    const auto found = contact(scaled(kFlat, size), scaled(standing, size), ContactKind::Crossing);
    ASSERT_EQ(found.size(), 1U);
    expect_ends({found[0][0] / size, found[0][1] / size}, Vec3(1, 0, 0), Vec3(1, 1, 0));
  }
}

TEST(ContactSegments, SliverIsMetWhereItIs) {
  // 1e-9 wide, slanted so that no coordinate plane shows it; it runs through the face.
  const Vec3 a(1, 1, -1);
  const Vec3 b(2, 1.5, 2);
  const Corners sliver{a, b, a + Vec3(1e-9, 2e-9, 0)};
  // A third of the way from a to b.
  const Vec3 through = a + (b - a) / 3;
  const auto found = contact(sliver, kFlat, ContactKind::Crossing);
  ASSERT_EQ(found.size(), 1U);
  expect_ends(found[0], through, through, 1e-8);
  EXPECT_LE(distance_from_both(found, sliver, kFlat), 4e-9);
}

TEST(ContactSegments, AlmostParallelTrianglesHaveALineOnBoth) {
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    const Corners p = random_triangle(random);
    Corners q = random_triangle(random);
    // Into the plane of p, but for rounding and a little more.
    const Vec3 n = normal_of(p);
    if (n.isZero(0.0)) continue;
    for (Vec3& corner : q) {
      corner -= n * (n.dot(corner - p[0]) / n.squaredNorm());
      corner += n.normalized() * (static_cast<double>(below(random, 3)) - 1.0) * 0x1p-40;
    }
    const std::optional<ContactKind> kind = find_contact(p, q, Common::Nothing);
    if (!kind) continue;
    EXPECT_LE(distance_from_both(contact(p, q, *kind), p, q), 4e-9);
  }
}

TEST(ContactSegments, TrianglesThatAreApartHaveAPointBetweenThem) {
  const Corners above{Vec3(1, 1, 1), Vec3(1, 3, 9), Vec3(3, 1, 9)};
  const auto found = contact(kFlat, above, ContactKind::Touching);
  ASSERT_EQ(found.size(), 1U);
  expect_ends(found[0], Vec3(1, 1, 0.5), Vec3(1, 1, 0.5), 0.1);
}

}  // namespace
}  // namespace meshalyzer
