#include "meshalyzer/defects/finders.h"
#include "support/effort.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

using Edge = std::array<Index, 2>;

DefectList slits_of(const Soup& soup, double tolerance) {
  return find_slits(PreparedMesh(soup), {.slit = tolerance});
}

/// Two squares of two faces side by side, the second one `gap` to the right; the edge 1-2 of the
/// first lies beside the edge 4-7 of the second.
Soup two_squares(double gap) {
  return shapes::make({{0, 0, 0},
                       {1, 0, 0},
                       {1, 1, 0},
                       {0, 1, 0},
                       {1 + gap, 0, 0},
                       {2 + gap, 0, 0},
                       {2 + gap, 1, 0},
                       {1 + gap, 1, 0}},
                      {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
}

/// Edges of a soup with one face, by counting.
std::vector<Edge> border_edges(const Soup& soup) {
  std::vector<Edge> edges;
  for (const Triangle& t : soup.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      edges.push_back({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> single;
  for (const Edge& edge : edges) {
    if (std::count(edges.begin(), edges.end(), edge) == 1) single.push_back(edge);
  }
  return single;
}

TEST(FindSlits, WeldedOrFarApartMeshHasNone) {
  EXPECT_TRUE(slits_of(shapes::cube(), 1e-3).empty());
  EXPECT_TRUE(slits_of(shapes::grid(3, 3), 1e-3).empty());
  EXPECT_TRUE(slits_of(two_squares(0.5), 1e-3).empty());
  EXPECT_TRUE(slits_of(Soup{}, 1.0).empty());
}

TEST(FindSlits, EdgesAtExactlyTheSamePlaceAreOneAlsoWithoutTolerance) {
  const DefectList found = slits_of(two_squares(0.0), 0.0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, DefectCode::Slit);
  EXPECT_EQ(found[0].edges, (std::vector<Edge>{{1, 2}, {4, 7}}));
  EXPECT_EQ(found[0].value, 0.0);
  EXPECT_EQ(found[0].limit, 0.0);
  EXPECT_EQ(found[0].positions, (std::vector<Vec3>{{1, 0.5, 0}}));
}

TEST(FindSlits, ZerosOfEitherSignAreOnePlace) {
  Soup soup = two_squares(0.0);
  soup.positions[4][1] = -0.0;
  EXPECT_EQ(slits_of(soup, 0.0).size(), 1U);
}

TEST(FindSlits, EdgesThatRunTheSameWayCountToo) {
  Soup soup = two_squares(0.0);
  for (const Index f : {2U, 3U}) std::swap(soup.triangles[f][0], soup.triangles[f][1]);
  EXPECT_EQ(slits_of(soup, 0.0).size(), 1U);
}

TEST(FindSlits, GapIsMeasuredAgainstTheTolerance) {
  const double gap = 0x1p-10;
  const DefectList found = slits_of(two_squares(gap), gap);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].value, gap);
  EXPECT_TRUE(slits_of(two_squares(gap), 0.999 * gap).empty());
}

TEST(FindSlits, OneEndWithinTheToleranceIsNotEnough) {
  Soup soup = two_squares(0.0);
  soup.positions[7][0] += 0.01;
  EXPECT_TRUE(slits_of(soup, 0.009).empty());
  EXPECT_EQ(slits_of(soup, 0.011).size(), 1U);
}

TEST(FindSlits, TipOfASlitCounts) {
  // The same with both squares joined at the lower end of the slit.
  Soup soup = two_squares(0.0);
  for (Triangle& t : soup.triangles) std::replace(t.begin(), t.end(), Index{4}, Index{1});
  const DefectList found = slits_of(soup, 0.0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].edges, (std::vector<Edge>{{1, 2}, {1, 7}}));
}

TEST(FindSlits, ChainJoinedAtVerticesIsOne) {
  // Two sheets of 1 x 4 squares side by side: four pairs of edges.
  const Soup soup =
      shapes::merged(shapes::grid(1, 4), shapes::translated(shapes::grid(1, 4), {1, 0, 0}));
  const DefectList found = slits_of(soup, 0.0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].edges.size(), 8U);
}

TEST(FindSlits, PairsWithoutCommonVertexAreSeveral) {
  // A square between two others.
  const Soup soup =
      shapes::merged(two_squares(0.0), shapes::translated(shapes::grid(1, 1), {-1, 0, 0}));
  // The edge 0-3 and that of the third square, 9-11, are not joined with the others: 1-2 and 4-7.
  const DefectList found = slits_of(soup, 0.0);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].edges.front(), (Edge{0, 3}));
  EXPECT_EQ(found[1].edges.front(), (Edge{1, 2}));
}

TEST(FindSlits, SidesOfANeedleAreNone) {
  // Its short edge is within the tolerance, so that its long ones have near ends.
  const Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}, {1, 1e-5, 0}}, {{0, 1, 2}});
  EXPECT_TRUE(slits_of(soup, 1e-4).empty());
  const Soup flat = shapes::make({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}, {{0, 1, 2}});
  EXPECT_TRUE(slits_of(flat, 0.0).empty());
}

TEST(FindSlits, EdgesNoLongerThanTheToleranceAreNoneButAtTheSamePlace) {
  // A sheet with squares of 1e-3: all ends of neighbouring edges are within the tolerance.
  const Soup fine = shapes::scaled(shapes::grid(4, 4), 1e-3);
  EXPECT_TRUE(slits_of(fine, 2e-3).empty());
  EXPECT_EQ(slits_of(shapes::scaled(two_squares(0.0), 1e-3), 1.0).size(), 1U);
}

TEST(FindSlits, UnweldedMeshIsSlitAlongAllItsEdges) {
  const Soup sphere = shapes::icosphere(2);
  Soup soup;
  for (const Triangle& t : sphere.triangles) {
    const auto first = static_cast<Index>(soup.positions.size());
    for (const Index v : t) soup.positions.push_back(sphere.positions[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const DefectList found = slits_of(soup, 0.0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].edges.size(), 3 * soup.n_faces());
}

TEST(FindSlits, AgreesWithComparingAllPairs) {
  std::mt19937 random(23);
  for (int i = 0; i < 40; ++i) {
    Soup soup = damaged(shapes::grid(5, 5), 5, random);
    Soup other = damaged(shapes::grid(5, 5), 5, random);
    for (Vec3& p : other.positions) {
      for (Eigen::Index k = 0; k < 3; ++k) p[k] += (below(random, 2001) - 1000.0) * 1e-5;
    }
    soup = shapes::translated(shapes::merged(soup, other), Vec3(-2.3, 5.1, 0.7) * (i % 3));
    const double tolerance = 0.01;
    const std::vector<Edge> edges = border_edges(soup);
    // No face has two edges within the tolerance of each other here, and none is so short.
    std::set<Edge> expected;
    const auto distance = [&](Index a, Index b) {
      return (soup.positions[a] - soup.positions[b]).norm();
    };
    for (const Edge& e : edges) {
      for (const Edge& f : edges) {
        if (e == f) continue;
        const double straight = std::max(distance(e[0], f[0]), distance(e[1], f[1]));
        const double crossed = std::max(distance(e[0], f[1]), distance(e[1], f[0]));
        if (std::min(straight, crossed) <= tolerance) expected.insert(e);
      }
    }
    std::set<Edge> found;
    for (const Defect& defect : slits_of(soup, tolerance)) {
      EXPECT_TRUE(std::is_sorted(defect.edges.begin(), defect.edges.end()));
      found.insert(defect.edges.begin(), defect.edges.end());
    }
    EXPECT_EQ(found, expected);
  }
}

TEST(FindSlits, EdgesWithOneMiddleAreFoundInNoTime) {
  // The diameters of a circle, one of them twice: none may be compared with all others.
  const auto count = static_cast<Index>(200'000 / test::one_of());
  Soup soup;
  for (Index i = 0; i <= count; ++i) {
    const double angle = 3.0 * (i % count) / count;
    soup.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    soup.positions.emplace_back(-std::cos(angle), -std::sin(angle), 0);
    soup.positions.emplace_back(0, 0, 1.0 + i);
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const DefectList found = slits_of(soup, 1e-6);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].edges, (std::vector<Edge>{{0, 1}, {3 * count, 3 * count + 1}}));
}

TEST(FindSlits, SurvivesExtremeCoordinates) {
  for (const double factor : {1e-320, 1e-200, 1e200, 1e307}) {
    EXPECT_EQ(slits_of(shapes::scaled(two_squares(0.0), factor), 0.0).size(), 1U);
    EXPECT_TRUE(slits_of(shapes::scaled(two_squares(0.5), factor), 0.1 * factor).empty());
  }
}

}  // namespace
}  // namespace meshalyzer
