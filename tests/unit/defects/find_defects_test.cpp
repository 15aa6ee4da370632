#include "meshalyzer/defects/find_defects.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/defects/catalogue.h"
#include "support/foldovers.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

/// The first face in the plane z = 0.
Triangle lowest_face(const Soup& soup) {
  return *std::find_if(soup.triangles.begin(), soup.triangles.end(), [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](Index v) { return soup.positions[v].z() == 0.0; });
  });
}

/// A cube without its lid, a face of its bottom twice, an orphan, a face without area, a missing
/// vertex, and wrong ids.
Soup ugly_cube() {
  Soup soup = shapes::open_cube();
  soup.triangles.push_back(lowest_face(soup));
  soup.positions.emplace_back(9, 9, 9);
  soup.triangles.push_back({0, 0, 1});
  soup.triangles.push_back({0, 1, kNoIndex});
  soup.missing = {{static_cast<Index>(soup.n_faces() - 1), 2, 77}};
  soup.vertex_ids.first = 2;
  return soup;
}

std::vector<DefectCode> codes_of(const DefectReport& report) {
  std::vector<DefectCode> codes;
  for (const Defect& defect : report.defects) codes.push_back(defect.code);
  return codes;
}

/// All that tells two reports apart, in words.
std::vector<std::string> described(const DefectReport& report) {
  std::vector<std::string> lines;
  for (const Defect& defect : report.defects) {
    std::string& line = lines.emplace_back(defect_name(defect.code));
    for (const Index v : defect.vertices) line += " v" + std::to_string(v);
    for (const auto& [a, b] : defect.edges)
      line += " e" + std::to_string(a) + "-" + std::to_string(b);
    for (const Index f : defect.faces) line += " f" + std::to_string(f);
    line += " " + std::to_string(defect.value.value_or(-1.0)) + " " + defect.detail;
  }
  return lines;
}

TEST(FindDefects, GoodMeshHasNone) {
  for (const Soup& soup : {shapes::cube(), shapes::torus(3, 1, 12, 8), Soup{},
                           shapes::nested_cubes(shapes::InnerShell::Cavity)}) {
    DefectOptions options;
    options.codes.erase(DefectCode::Disjoint);
    const DefectReport report = find_defects(soup, options);
    EXPECT_EQ(report.total(), 0U);
    EXPECT_TRUE(report.defects.empty());
    EXPECT_TRUE(report.warnings.empty());
  }
}

TEST(FindDefects, EachIsFoundUnderItsCode) {
  const DefectReport report = find_defects(ugly_cube());
  EXPECT_EQ(report.count(DefectCode::DegenerateFacet), 1U);
  EXPECT_EQ(report.count(DefectCode::Corrupt), 1U);
  EXPECT_EQ(report.count(DefectCode::Hole), 1U);
  EXPECT_EQ(report.count(DefectCode::DuplicateFacet), 1U);
  EXPECT_EQ(report.count(DefectCode::OrphanVertex), 1U);
  EXPECT_EQ(report.count(DefectCode::Numbering), 1U);
  EXPECT_EQ(report.count(DefectCode::NonManifold),
            3U);  // The edges of the face that is there twice.
  EXPECT_EQ(report.count(DefectCode::SelfIntersection), 1U);
  EXPECT_EQ(report.count(DefectCode::Disjoint), 0U);
  EXPECT_EQ(report.total(), report.defects.size());
  EXPECT_FALSE(report.is_cut());
}

TEST(FindDefects, TheyAreInOrderOfTheirCodes) {
  const std::vector<DefectCode> codes = codes_of(find_defects(ugly_cube()));
  EXPECT_TRUE(std::is_sorted(codes.begin(), codes.end()));
}

TEST(FindDefects, SeverityIsThatOfTheCatalogue) {
  for (const Defect& defect : find_defects(ugly_cube()).defects) {
    EXPECT_EQ(defect.severity, catalogue_entry(defect.code).severity) << defect_name(defect.code);
  }
}

TEST(FindDefects, OnlyWhatIsAskedForIsLookedFor) {
  for (const DefectCode code : all_defect_codes()) {
    SCOPED_TRACE(defect_name(code));
    const DefectReport all = find_defects(ugly_cube());
    const DefectReport one = find_defects(ugly_cube(), {.codes = {code}});
    EXPECT_EQ(one.count(code), all.count(code));
    EXPECT_EQ(one.total(), all.count(code));
  }
}

TEST(FindDefects, CutListIsTheBeginningAndCountsStayComplete) {
  const DefectReport all = find_defects(ugly_cube());
  for (std::size_t n = 1; n <= all.total() + 1; ++n) {
    const DefectReport cut = find_defects(ugly_cube(), {.max_defects = n});
    EXPECT_EQ(cut.counts, all.counts);
    EXPECT_EQ(cut.is_cut(), n < all.total());
    std::vector<std::string> expected = described(all);
    expected.resize(std::min(n, expected.size()));
    EXPECT_EQ(described(cut), expected);
  }
}

TEST(FindDefects, TolerancesAreThoseThatWereUsed) {
  const DefectReport report =
      find_defects(shapes::cube(), {.tolerances = {.tolerance = 0.5, .slit = 0.25}});
  EXPECT_EQ(report.tolerances.degeneracy, 0.5);
  EXPECT_EQ(report.tolerances.slit, 0.25);
  EXPECT_EQ(report.warnings.size(), 1U);
}

TEST(FindDefects, DefaultToleranceDoesNotDependOnOrphans) {
  Soup soup = shapes::cube();
  const double tolerance = find_defects(soup).tolerances.degeneracy;
  soup.positions.emplace_back(1e9, 0, 0);
  EXPECT_EQ(find_defects(soup).tolerances.degeneracy, tolerance);
}

TEST(FindDefects, RefusesToleranceThatIsNoLength) {
  EXPECT_THROW((void)find_defects(shapes::cube(), {.tolerances = {.tolerance = -1.0}}),
               InvalidArgument);
}

TEST(FindDefects, OfAMeshWithoutFinitePositionsOnlyTheRecordsAreChecked) {
  Soup soup = ugly_cube();
  soup.positions[0].x() = std::numeric_limits<double>::quiet_NaN();
  const DefectReport report = find_defects(soup);
  EXPECT_EQ(report.count(DefectCode::Corrupt), 2U);
  EXPECT_EQ(report.count(DefectCode::OrphanVertex), 1U);
  EXPECT_EQ(report.count(DefectCode::Numbering), 1U);
  EXPECT_EQ(report.total(), 4U);
}

TEST(FindDefects, AreTheSameForAnyNumberOfThreads) {
  std::mt19937 random(20270114);
  for (Index round = 0; round < 5; ++round) {
    const Soup soup = damaged(shapes::icosphere(4), 10 + 20 * round, random);
    const std::vector<std::string> many = described(find_defects(soup));
    EXPECT_FALSE(many.empty());
    const ThreadLimit one(1);
    EXPECT_EQ(described(find_defects(soup)), many);
  }
}

TEST(FindDefects, SearchForFoldoversThatIsStoppedSaysSo) {
  const Soup soup = shapes::dragged_vertex();
  EXPECT_EQ(find_defects(soup).count(DefectCode::Foldover), 1U);
  EXPECT_TRUE(find_defects(soup).warnings.empty());
  DefectOptions options;
  options.wants_to_stop = [] { return true; };
  const DefectReport stopped = find_defects(soup, options);
  EXPECT_EQ(stopped.count(DefectCode::Foldover), 0U);
  ASSERT_EQ(stopped.warnings.size(), 1U);
  EXPECT_NE(stopped.warnings.front().find("foldovers"), std::string::npos);
}

TEST(FindDefects, EndedSearchForPairsLeavesOnlyTheNestingOfComponentsUnknown) {
  const DefectOptions options{.pairs = {.wants_to_stop = [] { return true; }}};
  const DefectReport one = find_defects(shapes::flipped(shapes::cube()), options);
  EXPECT_EQ(one.unfinished, DefectCodes{DefectCode::SelfIntersection});
  EXPECT_EQ(one.count(DefectCode::Inward), 1U);
  ASSERT_EQ(one.warnings.size(), 1U);
  EXPECT_EQ(one.warnings.front().find("inward"), std::string::npos);

  const DefectReport two =
      find_defects(shapes::merged(shapes::cube(), shapes::cube(1, {2, 0, 0})), options);
  EXPECT_EQ(two.unfinished, (DefectCodes{DefectCode::SelfIntersection, DefectCode::Inward}));
  ASSERT_EQ(two.warnings.size(), 1U);
  EXPECT_NE(two.warnings.front().find("inward"), std::string::npos);
}

TEST(FindDefects, SoupThatContradictsItselfIsRefusedWhateverElseIsWrong) {
  Soup soup = shapes::cube();
  soup.triangles[3][1] = 8;
  EXPECT_THROW(static_cast<void>(find_defects(soup)), InvalidArgument);
  soup.positions[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(find_defects(soup)), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
