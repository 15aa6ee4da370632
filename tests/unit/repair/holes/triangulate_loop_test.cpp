#include "meshalyzer/repair/holes/internal/triangulate_loop.h"

#include "meshalyzer/repair/holes/internal/triangulate_large_loop.h"
#include "unit/repair/holes/hole_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

/// A polygon with nothing beyond its edges, or faces with given normals.
class Loop {
 public:
  explicit Loop(std::vector<Vec3> points, std::vector<Vec3> normals = {}) : existing_(mesh_, {}) {
    for (Index i = 0; i < points.size(); ++i) polygon_.vertices.push_back(i);
    polygon_.normals = std::move(normals);
    polygon_.normals.resize(points.size(), Vec3::Zero());
    polygon_.points = std::move(points);
    rules_.existing = &existing_;
  }

  [[nodiscard]] const LoopPolygon& polygon() const { return polygon_; }
  [[nodiscard]] LoopRules& rules() { return rules_; }

  [[nodiscard]] double area(const std::vector<Triangle>& triangles) const {
    double area = 0.0;
    for (const Triangle& t : triangles) area += area_of(t);
    return area;
  }
  [[nodiscard]] double area_of(const Triangle& t) const {
    const Vec3& a = polygon_.points[t[0]];
    return 0.5 * (polygon_.points[t[1]] - a).cross(polygon_.points[t[2]] - a).norm();
  }

  /// The least area of all triangulations, each looked at.
  [[nodiscard]] double least_area(Index i, Index j) const {
    if (j == i + 1) return 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (Index k = i + 1; k < j; ++k) {
      least = std::min(least, least_area(i, k) + least_area(k, j) + area_of({i, k, j}));
    }
    return least;
  }

 private:
  Soup soup_;
  PreparedMesh mesh_{soup_};
  ExistingEdges existing_;
  LoopPolygon polygon_;
  LoopRules rules_;
};

std::vector<Vec3> random_loop(std::size_t n, std::mt19937& random) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double a = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const double r = 0.5 + below(random, 1000) / 1000.0;
    points.emplace_back(r * std::cos(a), r * std::sin(a), below(random, 1000) / 1000.0);
  }
  return points;
}

/// The area of a flat loop, by Gauss's formula.
double flat_area(const std::vector<Vec3>& points) {
  double twice = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[i];
    const Vec3& q = points[(i + 1) % points.size()];
    twice += p.x() * q.y() - q.x() * p.y();
  }
  return 0.5 * twice;
}

TEST(TriangulateLoop, FindsTheLeastAreaOfAll) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    Loop loop(random_loop(8, random));
    loop.rules().weight = LoopWeight::Area;
    const auto found = triangulate_loop(loop.polygon(), loop.rules());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->size(), 6U);
    // Its weight has a share of edge lengths too, of 1e-7.
    EXPECT_NEAR(loop.area(*found), loop.least_area(0, 7), 1e-4);
  }
}

TEST(TriangulateLoop, NeverOverlapsInAPlane) {
  std::mt19937 random(6);
  for (const LoopWeight weight : {LoopWeight::BendThenArea, LoopWeight::Area, LoopWeight::Flat}) {
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<Vec3> points = random_loop(40, random);
      for (Vec3& p : points) p.z() = 0.0;
      Loop loop(points);
      loop.rules().weight = weight;
      const auto found = triangulate_large_loop(loop.polygon(), loop.rules());
      ASSERT_TRUE(found);
      EXPECT_NEAR(loop.area(*found), flat_area(points), 1e-12);
    }
  }
}

TEST(TriangulateLoop, LeavesOutWhatIsForbidden) {
  Loop square({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)});
  const auto first = triangulate_loop(square.polygon(), square.rules());
  ASSERT_TRUE(first);
  square.rules().forbid({first->front()});
  const auto second = triangulate_loop(square.polygon(), square.rules());
  ASSERT_TRUE(second);
  for (const Triangle& t : *second) {
    EXPECT_EQ(std::count(first->begin(), first->end(), t), 0);
  }
  square.rules().forbid({second->front()});
  EXPECT_FALSE(triangulate_loop(square.polygon(), square.rules()));
}

TEST(TriangulateLoop, TakesACollinearTriangleOnlyWhereThereIsNoOther) {
  // A triangle with two more vertices on its base.
  Loop loop({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0), Vec3(1, 2, 0)});
  const auto found = triangulate_loop(loop.polygon(), loop.rules());
  ASSERT_TRUE(found);
  for (const Triangle& t : *found) EXPECT_GT(loop.area_of(t), 0.0);

  Loop line({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)});
  EXPECT_TRUE(triangulate_loop(line.polygon(), line.rules()));
}

TEST(TriangulateLargeLoop, CutsNoEarWithACornerInIt) {
  // A square with a spike from its upper right into its lower left, where the corner has by far
  // the shortest chord.
  const std::vector<Vec3> points{Vec3(0, 0, 0),    Vec3(1, 0, 0),     Vec3(10, 0, 0),
                                 Vec3(10, 9.9, 0), Vec3(0.2, 0.2, 0), Vec3(9.9, 10, 0),
                                 Vec3(0, 10, 0),   Vec3(0, 1, 0)};
  Loop loop(points);
  loop.rules().weight = LoopWeight::Flat;
  const auto found = triangulate_large_loop(loop.polygon(), loop.rules());
  ASSERT_TRUE(found);
  EXPECT_NEAR(loop.area(*found), flat_area(points), 1e-12);
}

TEST(TriangulateLargeLoop, FillsASpiral) {
  // Two arms, one beside the other, three times round: every chord but those across the strip would
  // overlap.
  std::vector<Vec3> points;
  constexpr int kSteps = 1000;
  const auto at = [](int i, double width) {
    const double turn = 6.0 * std::numbers::pi * i / kSteps;
    const double r = 1.0 + turn / 6.0 + width;
    return Vec3(r * std::cos(turn), r * std::sin(turn), 0.0);
  };
  for (int i = 0; i <= kSteps; ++i) points.push_back(at(i, 0.4));
  for (int i = kSteps; i >= 0; --i) points.push_back(at(i, 0.0));
  Loop loop(points);
  for (const LoopWeight weight : {LoopWeight::BendThenArea, LoopWeight::Flat}) {
    loop.rules().weight = weight;
    const auto found = triangulate_large_loop(loop.polygon(), loop.rules());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->size(), points.size() - 2);
    EXPECT_NEAR(loop.area(*found), flat_area(points), 1e-9);
  }
}

/// A strip of the unit cylinder, more than once round, so that it covers itself from every side.
struct WindingSlot {
  static constexpr double kWidth = 0.2;
  static constexpr double kTurn = 2.2 * std::numbers::pi;
  std::vector<Vec3> points;
  /// Of the faces beyond the edges.
  std::vector<Vec3> normals;

  WindingSlot() {
    for (int i = 0; i <= kSteps; ++i) add(i, 0.0, 0.5);
    for (int i = kSteps; i >= 0; --i) add(i, kWidth, -0.5);
  }

 private:
  static constexpr int kSteps = 300;

  void add(int i, double height, double half_step) {
    const double turn = kTurn * i / kSteps;
    points.emplace_back(std::cos(turn), std::sin(turn), 0.1 * turn + height);
    const double middle = turn + half_step * kTurn / kSteps;
    normals.emplace_back(std::cos(middle), std::sin(middle), 0.0);
  }
};

TEST(TriangulateLargeLoop, FillsASlotThatWindsRoundACylinderAlongIt) {
  const WindingSlot slot;
  Loop loop(slot.points, slot.normals);
  for (const LoopWeight weight : {LoopWeight::BendThenArea, LoopWeight::Area}) {
    loop.rules().weight = weight;
    const auto found = triangulate_large_loop(loop.polygon(), loop.rules());
    ASSERT_TRUE(found);
    // Unrolled, the strip is a parallelogram with the base kTurn and the height kWidth. Triangles
    // that lie along it are chords of the cylinder, which have hardly less area.
    const double area = WindingSlot::kTurn * WindingSlot::kWidth;
    EXPECT_NEAR(loop.area(*found), area, 0.01 * area);
    for (const Triangle& t : *found) {
      const Vec3 middle = (slot.points[t[0]] + slot.points[t[1]] + slot.points[t[2]]) / 3.0;
      EXPECT_GT(middle.head<2>().norm(), 0.95);
    }
  }
}

TEST(TriangulateLargeLoop, FlatTriangulationDoesNotDependOnTheFacesBeyond) {
  const WindingSlot slot;
  Loop with(slot.points, slot.normals);
  Loop without(slot.points);
  with.rules().weight = LoopWeight::Flat;
  without.rules().weight = LoopWeight::Flat;
  EXPECT_EQ(triangulate_large_loop(with.polygon(), with.rules()),
            triangulate_large_loop(without.polygon(), without.rules()));
}

}  // namespace
}  // namespace meshalyzer
