#include "meshalyzer/picture/internal/worst_defects.h"

#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace meshalyzer {
namespace {

double value(DefectCode code) {
  return 1.0 + static_cast<double>(code);
}

/// A strip of four faces; face i is on vertices i, i + 1 and i + 2.
Soup strip() {
  return shapes::make({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 0}},
                      {{1, 0, 2}, {1, 2, 3}, {3, 2, 4}, {3, 4, 5}});
}

DefectReport report_of(DefectList defects) {
  DefectReport report;
  report.defects = std::move(defects);
  return report;
}

TEST(WorstDefects, NothingListedIsNought) {
  EXPECT_EQ(worst_defects(strip(), {}), (std::vector<double>{0, 0, 0, 0}));
}

TEST(WorstDefects, ListedFaceIsInTheDefect) {
  Defect defect = make_defect(DefectCode::FlatFacet);
  defect.faces = {1, 3};
  const double flat = value(DefectCode::FlatFacet);
  EXPECT_EQ(worst_defects(strip(), report_of({defect})), (std::vector<double>{0, flat, 0, flat}));
}

TEST(WorstDefects, FacesAtAListedVertexAreInTheDefect) {
  Defect defect = make_defect(DefectCode::NonManifold);
  defect.vertices = {4};
  const double bad = value(DefectCode::NonManifold);
  EXPECT_EQ(worst_defects(strip(), report_of({defect})), (std::vector<double>{0, 0, bad, bad}));
}

TEST(WorstDefects, FacesAtAListedEdgeAreInTheDefectWhicheverEndIsFirst) {
  const double hole = value(DefectCode::Hole);
  Defect defect = make_defect(DefectCode::Hole);
  for (const std::array<Index, 2> edge : {std::array<Index, 2>{2, 3}, {3, 2}}) {
    defect.edges = {edge};
    EXPECT_EQ(worst_defects(strip(), report_of({defect})), (std::vector<double>{0, hole, hole, 0}));
  }
  // Its ends alone are not enough: the edge from the last corner to the first.
  defect.edges = {{0, 1}, {5, 3}};
  EXPECT_EQ(worst_defects(strip(), report_of({defect})), (std::vector<double>{hole, 0, 0, hole}));
}

TEST(WorstDefects, ErrorGoesBeforeWarningThenTheFirstCode) {
  Defect warning = make_defect(DefectCode::Disjoint);
  ASSERT_EQ(warning.severity, Severity::Warning);
  warning.faces = {0, 1, 2, 3};
  Defect later = make_defect(DefectCode::Inward);
  later.vertices = {2};  // faces 0, 1 and 2
  Defect earlier = make_defect(DefectCode::Slit);
  earlier.edges = {{1, 0}, {1, 2}};  // faces 0 and 1
  Defect same_edge = make_defect(DefectCode::Flipped);
  same_edge.edges = {{2, 1}};
  const std::vector<double> expected{value(DefectCode::Slit), value(DefectCode::Slit),
                                     value(DefectCode::Inward), value(DefectCode::Disjoint)};
  EXPECT_EQ(worst_defects(strip(), report_of({warning, later, earlier, same_edge})), expected);
  EXPECT_EQ(worst_defects(strip(), report_of({same_edge, earlier, later, warning})), expected);
}

TEST(WorstDefects, FacesWithoutAllCornersHaveTheirOwn) {
  Soup soup = strip();
  soup.triangles.push_back({0, kNoIndex, 1});
  soup.triangles.push_back({kNoIndex, kNoIndex, kNoIndex});
  Defect corrupt = make_defect(DefectCode::Corrupt);
  corrupt.faces = {5};
  Defect hole = make_defect(DefectCode::Hole);
  hole.edges = {{1, 0}};
  EXPECT_EQ(worst_defects(soup, report_of({corrupt, hole})),
            (std::vector<double>{value(DefectCode::Hole), 0, 0, 0, value(DefectCode::Hole),
                                 value(DefectCode::Corrupt)}));
}

TEST(WorstDefects, CubeWithoutTopHasAHoleAtTheFourFacesBelow) {
  const Soup soup = shapes::open_cube();
  const std::vector<double> values = worst_defects(soup, find_defects(soup));
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    const Triangle& t = soup.triangles[f];
    // Vertices 4 ... 7 are those at z = 1; a side's upper face has two of them.
    const bool is_at_border =
        std::count_if(t.begin(), t.end(), [](Index v) { return v >= 4; }) == 2;
    EXPECT_EQ(values[f], is_at_border ? value(DefectCode::Hole) : 0.0) << f;
  }
}

TEST(WorstDefects, CrossingCubesIntersectWhereTheirPairsAre) {
  const Soup soup = shapes::merged(shapes::cube(), shapes::cube(1, {0.5, 0.25, 0.375}));
  const PreparedMesh mesh(soup);
  std::set<Index> crossing;
  for (const IntersectingPair& pair : mesh.intersecting_pairs()) {
    crossing.insert({pair.face_a, pair.face_b});
  }
  ASSERT_GT(crossing.size(), 1U);
  ASSERT_LT(crossing.size(), 24U);
  const std::vector<double> values = worst_defects(soup, find_defects(mesh));
  for (Index f = 0; f < soup.n_faces(); ++f) {
    // The second cube is a second component, told of at its first face.
    const double other = f == 12 ? value(DefectCode::Disjoint) : 0.0;
    EXPECT_EQ(values[f], crossing.count(f) != 0 ? value(DefectCode::SelfIntersection) : other) << f;
  }
}

TEST(SpreadOverComponents, EveryFaceOfANamedComponentIsInTheDefectWhereNoWorseOneIs) {
  // Two cubes; faces 12 ... 23 are the second. Face 14 has an error of its own.
  const Soup soup = shapes::merged(shapes::cube(), shapes::translated(shapes::cube(), {5, 0, 0}));
  const CutMesh cut = build(soup);
  Defect disjoint = make_defect(DefectCode::Disjoint);
  disjoint.faces = {12};
  Defect flat = make_defect(DefectCode::SelfIntersection);
  flat.faces = {14};
  const DefectReport report = report_of({disjoint, flat});
  std::vector<double> expected(24, 0.0);
  std::fill(expected.begin() + 12, expected.end(), value(DefectCode::Disjoint));
  expected[14] = value(DefectCode::SelfIntersection);
  EXPECT_EQ(spread_over_components(worst_defects(soup, report), report, cut, find_components(cut)),
            expected);
}

}  // namespace
}  // namespace meshalyzer
