#include "meshalyzer/arrangement/flip_edges.h"
#include "meshalyzer/arrangement/insert_segment.h"
#include "meshalyzer/arrangement/triangulate_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace meshalyzer {
namespace {

/// Points of the plane z = 0, in order.
std::vector<ExactPoint> points_of(std::set<std::pair<int, int>> places) {
  std::vector<ExactPoint> points;
  for (const auto& [x, y] : places) points.push_back(exact_point(Vec3(x, y, 0)));
  return points;
}

std::set<std::pair<int, int>> random_places(std::size_t n, int size, std::mt19937& random) {
  std::set<std::pair<int, int>> places;
  std::uniform_int_distribution<> coordinate(0, size - 1);
  while (places.size() < n) places.insert({coordinate(random), coordinate(random)});
  return places;
}

Triangulation triangulate(const std::vector<ExactPoint>& points) {
  std::vector<const ExactPoint*> pointers;
  for (const ExactPoint& p : points) pointers.push_back(&p);
  return triangulate_hull(Axis::Z, std::move(pointers));
}

/// Twice the area of all triangles, each of which must be counter-clockwise and linked well.
double checked_area(const Triangulation& t) {
  double area = 0;
  for (Index h = 0; h < t.origin.size(); ++h) {
    EXPECT_EQ(t.origin[t.leaving[t.origin[h]]], t.origin[h]);
    if (t.twin[h] != kNoIndex) {
      EXPECT_EQ(t.twin[t.twin[h]], h);
      EXPECT_EQ(t.origin[t.twin[h]], t.target(h));
      EXPECT_EQ(t.constrained[t.twin[h]], t.constrained[h]);
    }
    if (h % 3 == 0) {
      const Index a = t.origin[h];
      const Index b = t.origin[h + 1];
      const Index c = t.origin[h + 2];
      EXPECT_EQ(t.turn(a, b, c), 1);
      const Vec3 u = t.points[b]->rounded - t.points[a]->rounded;
      const Vec3 v = t.points[c]->rounded - t.points[a]->rounded;
      area += u.cross(v).z();
    }
  }
  return area;
}

/// Twice the area of the convex hull, whose lower and upper chains are found by the scan of Andrew:
/// exact in small integers.
double hull_area(const Triangulation& t) {
  double area = 0;
  for (const Sign side : {1, -1}) {
    std::vector<Index> chain;
    for (Index i = 0; i < t.points.size(); ++i) {
      while (chain.size() > 1 && t.turn(chain[chain.size() - 2], chain.back(), i) * side <= 0) {
        chain.pop_back();
      }
      chain.push_back(i);
    }
    for (std::size_t k = 1; k < chain.size(); ++k) {
      const Vec3& from = t.points[chain[k - 1]]->rounded;
      area += side * from.cross(t.points[chain[k]]->rounded).z();
    }
  }
  return area;
}

TEST(TriangulateHull, FillsTheHullWithAllPoints) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    const auto points = points_of(random_places(12, 4 + round % 5, random));
    const Triangulation t = triangulate(points);
    EXPECT_EQ(checked_area(t), hull_area(t));
    std::set<Index> used(t.origin.begin(), t.origin.end());
    EXPECT_EQ(used.size(), points.size());
  }
}

TEST(TriangulateHull, BeginsWithPointsInOneLine) {
  const auto points = points_of({{0, 0}, {0, 1}, {0, 2}, {0, 3}, {1, 1}});
  const Triangulation t = triangulate(points);
  EXPECT_EQ(t.n_triangles(), 3U);
  EXPECT_EQ(checked_area(t), 3.0);
}

TEST(FlipEdges, KeepsTheTriangulationValid) {
  std::mt19937 random(2);
  for (int round = 0; round < 100; ++round) {
    const auto points = points_of(random_places(20, 6 + round % 20, random));
    Triangulation t = triangulate(points);
    flip_edges(t);
    EXPECT_EQ(checked_area(t), hull_area(t));
  }
}

TEST(FlipEdges, LeavesNoCornerInACircle) {
  // The short diagonal of a rhombus.
  const auto points = points_of({{-9, 0}, {0, -1}, {0, 1}, {9, 0}});
  Triangulation t = triangulate(points);
  flip_edges(t);
  std::size_t n_short = 0;
  for (Index h = 0; h < t.origin.size(); ++h) n_short += t.origin[h] == 1 && t.target(h) == 2;
  EXPECT_EQ(n_short, 1U);
}

TEST(InsertSegment, MakesEdgesOfItThatStay) {
  std::mt19937 random(3);
  for (int round = 0; round < 400; ++round) {
    const auto points = points_of(random_places(24, 6 + round % 30, random));
    Triangulation t = triangulate(points);
    if (round % 2 == 0) flip_edges(t);
    // All from one vertex: they do not cross.
    const auto from = static_cast<Index>(random() % 24);
    std::set<std::pair<Index, Index>> asked;
    for (int i = 0; i < 6; ++i) {
      const auto to = static_cast<Index>(random() % 24);
      if (to == from) continue;
      const std::vector<Index> chain = insert_segment(t, from, to);
      EXPECT_EQ(chain.front(), from);
      EXPECT_EQ(chain.back(), to);
      for (std::size_t k = 1; k < chain.size(); ++k)
        asked.insert(std::minmax(chain[k - 1], chain[k]));
    }
    flip_edges(t);
    EXPECT_EQ(checked_area(t), hull_area(t));
    std::set<std::pair<Index, Index>> found;
    for (Index h = 0; h < t.origin.size(); ++h) {
      if (t.constrained[h] != 0) found.insert(std::minmax(t.origin[h], t.target(h)));
    }
    EXPECT_EQ(found, asked);
  }
}

TEST(InsertSegment, NamesTheVerticesOnIt) {
  const auto points = points_of({{0, 0}, {1, 1}, {1, 4}, {2, 2}, {3, 0}, {3, 3}});
  Triangulation t = triangulate(points);
  EXPECT_EQ(insert_segment(t, 5, 0), (std::vector<Index>{5, 3, 1, 0}));
}

}  // namespace
}  // namespace meshalyzer
