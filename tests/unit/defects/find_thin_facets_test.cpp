#include "meshalyzer/defects/finders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace meshalyzer {
namespace {

DefectList thin_in(const Soup& soup, double tolerance) {
  return find_thin_facets(PreparedMesh(soup), {.degeneracy = tolerance});
}

/// One face.
Soup triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return shapes::make({a, b, c}, {{0, 1, 2}});
}

/// A cap: the apex stands `height` above the middle of an edge of length 2.
Soup cap(double height) {
  return triangle({-1, 0, 0}, {1, 0, 0}, {0, height, 0});
}

/// A right triangle with legs 1 and `width`, and so that as its shortest edge.
Soup needle(double width) {
  return triangle({0, 0, 0}, {1, 0, 0}, {0, width, 0});
}

void expect_one(const DefectList& defects, DefectCode code, double value) {
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_EQ(defects[0].code, code);
  EXPECT_EQ(defects[0].faces, std::vector<Index>{0});
  EXPECT_EQ(defects[0].positions.size(), 1U);
  ASSERT_TRUE(defects[0].value);
  EXPECT_NEAR(*defects[0].value, value, 1e-9 * value);
}

TEST(FindThinFacets, GoodFacesAreNot) {
  EXPECT_TRUE(thin_in(shapes::cube(), 0.5).empty());
  EXPECT_TRUE(thin_in({}, 1.0).empty());
}

TEST(FindThinFacets, AltitudeBelowTheToleranceIsFlat) {
  const DefectList defects = thin_in(cap(0.25), 0.5);
  expect_one(defects, DefectCode::FlatFacet, 0.25);
  EXPECT_EQ(defects[0].limit, 0.5);
  EXPECT_EQ(defects[0].severity, Severity::Error);
  EXPECT_TRUE(defects[0].edges.empty());
}

TEST(FindThinFacets, AltitudeOfJustTheToleranceIsNot) {
  EXPECT_TRUE(thin_in(cap(0.25), 0.25).empty());
  EXPECT_EQ(thin_in(cap(0.25), std::nextafter(0.25, 1.0)).size(), 1U);
}

TEST(FindThinFacets, EdgeBelowTheToleranceIsDegenerateAndNotFlatToo) {
  const DefectList defects = thin_in(needle(0.25), 0.5);
  expect_one(defects, DefectCode::DegenerateFacet, 0.25);
  EXPECT_EQ(defects[0].edges, (std::vector<std::array<Index, 2>>{{0, 2}}));
  EXPECT_EQ(defects[0].positions[0], Vec3(0, 0.125, 0));
  EXPECT_TRUE(defects[0].vertices.empty());
}

TEST(FindThinFacets, EdgeOfJustTheToleranceIsFlatOnly) {
  // Legs 1 and 1/4: the altitude is their product by the hypotenuse.
  expect_one(thin_in(needle(0.25), 0.25), DefectCode::FlatFacet, 0.25 / std::sqrt(1.0625));
}

TEST(FindThinFacets, AllShortEdgesAreListed) {
  const DefectList defects = thin_in(triangle({0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}), 0.5);
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_EQ(defects[0].edges, (std::vector<std::array<Index, 2>>{{0, 1}, {0, 2}, {1, 2}}));
}

TEST(FindThinFacets, RepeatedVertexIsDegenerateWhereverItStands) {
  for (const Triangle& t : {Triangle{1, 1, 0}, Triangle{0, 1, 1}, Triangle{1, 0, 1}}) {
    const DefectList defects = thin_in(shapes::make({Vec3(0, 0, 0), Vec3(8, 0, 0)}, {t}), 0.5);
    expect_one(defects, DefectCode::DegenerateFacet, 0.0);
    EXPECT_EQ(defects[0].vertices, std::vector<Index>{1});
    EXPECT_TRUE(defects[0].edges.empty());
    EXPECT_EQ(defects[0].positions[0], Vec3(8, 0, 0));
  }
}

TEST(FindThinFacets, OneVertexThriceIsDegenerate) {
  expect_one(thin_in(shapes::make({Vec3(0, 0, 0)}, {{0, 0, 0}}), 0.0), DefectCode::DegenerateFacet,
             0.0);
}

TEST(FindThinFacets, FaceWithAMissingVertexIsLeftToCorrupt) {
  EXPECT_TRUE(thin_in(shapes::make({Vec3(0, 0, 0)}, {{0, 0, kNoIndex}}), 1.0).empty());
}

TEST(FindThinFacets, ZeroAreaIsFlatAtToleranceZero) {
  // On one line to the last bit, and in floating point as good as on one line.
  expect_one(thin_in(triangle({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.4, 0.4, 0.4}), 0.0),
             DefectCode::FlatFacet, 0.0);
  const double above = std::nextafter(0.4, 1.0);
  EXPECT_TRUE(thin_in(triangle({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.4, 0.4, above}), 0.0).empty());
}

TEST(FindThinFacets, ZeroAreaIsSeenWhereRoundingHidesIt) {
  // t (3, 5, 0) for whole t: on one line exactly, but a difference with the first is rounded.
  const auto point = [](double t) { return Vec3(3 * t, 5 * t, 0); };
  constexpr double kFar = 0x1p50;
  for (double k = 1; k < 16; k += 2) {
    expect_one(thin_in(triangle(point(-kFar), point(kFar + k), point(-kFar + k)), 0.0),
               DefectCode::FlatFacet, 0.0);
  }
}

TEST(FindThinFacets, SamePlaceUnderTwoNumbersIsDegenerateAtToleranceZero) {
  const DefectList defects = thin_in(triangle({1, 2, 3}, {1, 2, 3}, {4, 5, 7}), 0.0);
  expect_one(defects, DefectCode::DegenerateFacet, 0.0);
  EXPECT_EQ(defects[0].edges, (std::vector<std::array<Index, 2>>{{0, 1}}));
}

TEST(FindThinFacets, SliverOfAnyHeightIsMeasured) {
  // Powers of two: heights that floating-point products lose, down to the smallest number.
  for (const int power : {-10, -24, -30, -60, -500, -1000, -1074}) {
    SCOPED_TRACE(power);
    const double height = std::ldexp(1.0, power);
    expect_one(thin_in(cap(height), 0.25), DefectCode::FlatFacet, height);
    EXPECT_TRUE(thin_in(cap(height), height).empty());
    EXPECT_TRUE(thin_in(cap(height), 0.0).empty());
  }
}

TEST(FindThinFacets, SizeOfTheMeshDoesNotMatter) {
  // Legs 4 and 3 give the hypotenuse 5 and the altitude 12/5.
  for (const int power : {-1060, -600, -340, -300, 0, 300, 340, 600, 1020}) {
    SCOPED_TRACE(power);
    const double unit = std::ldexp(1.0, power);
    const Soup soup = triangle({0, 0, 0}, {4 * unit, 0, 0}, {0, 3 * unit, 0});
    EXPECT_TRUE(thin_in(soup, 2.25 * unit).empty());
    ASSERT_EQ(thin_in(soup, 2.5 * unit).size(), 1U);
    const Defect defect = thin_in(soup, 2.5 * unit)[0];
    EXPECT_EQ(defect.code, DefectCode::FlatFacet);
    // The smallest numbers have but few digits.
    EXPECT_NEAR(*defect.value / unit, 2.4, power < -1022 ? 1e-3 : 1e-9);
    const Defect degenerate = thin_in(soup, 3.5 * unit).at(0);
    EXPECT_EQ(degenerate.code, DefectCode::DegenerateFacet);
    EXPECT_EQ(*degenerate.value, 3 * unit);
  }
}

TEST(FindThinFacets, LargestCoordinatesAreNotThin) {
  const double large = std::numeric_limits<double>::max();
  EXPECT_TRUE(
      thin_in(triangle({-large, -large, 0}, {large, -large, 0}, {0, large, 0}), 1.0).empty());
}

TEST(FindThinFacets, AgreesWithLongDoublesOnRandomFaces) {
  // Coordinates with 20 bits: the products have no rounding in the 64 bits of a long double.
  std::uint32_t state = 12345;
  const auto next = [&state] {
    state = state * 1664525U + 1013904223U;
    return std::ldexp(static_cast<double>(state >> 12U), -20) * (state % 3 == 0 ? 0.01 : 1.0);
  };
  std::size_t n_thin = 0;
  for (int round = 0; round < 20000 && !testing::Test::HasFailure(); ++round) {
    const Vec3 a(next(), next(), 0);
    const Vec3 b(next(), next(), 0);
    const Vec3 c(next(), next(), 0);
    using Long = long double;
    const auto span = [](const Vec3& p, const Vec3& q) {
      return std::hypot(Long{q.x()} - Long{p.x()}, Long{q.y()} - Long{p.y()});
    };
    const Long shortest = std::min({span(a, b), span(b, c), span(c, a)});
    const Long longest = std::max({span(a, b), span(b, c), span(c, a)});
    const Long area = std::abs((Long{b.x()} - Long{a.x()}) * (Long{c.y()} - Long{a.y()}) -
                               (Long{b.y()} - Long{a.y()}) * (Long{c.x()} - Long{a.x()}));
    constexpr double kTolerance = 0.05;
    const DefectList defects = thin_in(triangle(a, b, c), kTolerance);
    n_thin += defects.size();
    if (area / longest >= kTolerance) {
      EXPECT_TRUE(defects.empty());
    } else if (shortest < kTolerance) {
      expect_one(defects, DefectCode::DegenerateFacet, static_cast<double>(shortest));
    } else {
      expect_one(defects, DefectCode::FlatFacet, static_cast<double>(area / longest));
    }
  }
  EXPECT_GT(n_thin, 1000U);
}

TEST(FindThinFacets, FacesAreInFileOrderWhateverTheirNumber) {
  Soup soup = shapes::grid(100, 100);
  const std::size_t n = soup.n_faces();
  for (Index f = 0; f < n; f += 7) soup.triangles[f][2] = soup.triangles[f][1];
  const DefectList defects = thin_in(soup, 0.1);
  ASSERT_EQ(defects.size(), (n + 6) / 7);
  for (std::size_t i = 0; i < defects.size(); ++i) {
    EXPECT_EQ(defects[i].faces[0], static_cast<Index>(7 * i));
  }
}

}  // namespace
}  // namespace meshalyzer
