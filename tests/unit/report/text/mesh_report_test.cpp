#include "meshalyzer/report/text/mesh_report.h"

#include "has_line.h"
#include "sample_analysis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace meshalyzer {
namespace {

using test::HasLine;
using testing::HasSubstr;
using testing::Not;

std::string report_of(const Analysis& analysis) {
  return text_report(analysis, OffenderStyle::None);
}

TEST(TextReport, SectionsStandInOrder) {
  const std::string report = report_of(Analysis{});
  const std::size_t integrity = report.find("MESH FILE INTEGRITY\n");
  const std::size_t attributes = report.find("\n\nMESH ATTRIBUTES\n");
  const std::size_t characteristics = report.find("\n\nMESH CHARACTERISTICS\n");
  EXPECT_EQ(integrity, 0U);
  EXPECT_LT(integrity, attributes);
  EXPECT_LT(attributes, characteristics);
  EXPECT_NE(characteristics, std::string::npos);
}

TEST(TextReport, VerdictIsTheFirstLine) {
  Analysis analysis;
  analysis.fitness = Goodness{true, {}};
  EXPECT_EQ(report_of(analysis).find("verdict: good\n\nMESH FILE INTEGRITY\n"), 0U);
  analysis.fitness = Goodness{false, {"not closed", "orphan vertices: 2"}};
  EXPECT_EQ(report_of(analysis).find("verdict: NOT good: not closed; orphan vertices: 2\n"), 0U);
}

TEST(TextReport, AnswersAreYesNoOrUndefinedWithTheReason) {
  Analysis analysis;
  analysis.attributes.closed.value = true;
  analysis.attributes.manifold.value = false;
  analysis.attributes.outward.reason = "the mesh is not manifold";
  const std::string report = report_of(analysis);
  EXPECT_THAT(report, HasLine("closed: yes"));
  EXPECT_THAT(report, HasLine("manifold: no"));
  EXPECT_THAT(report, HasLine("outward: undefined (the mesh is not manifold)"));
}

TEST(TextReport, GenusWithOrphansTellsThatOfTheComponents) {
  Analysis analysis;
  analysis.characteristics.genus.reason = "50 orphan vertices";
  analysis.characteristics.genus_of_components = 5;
  EXPECT_THAT(report_of(analysis),
              HasLine("genus: undefined (50 orphan vertices; of the components: 5)"));
}

TEST(TextReport, GenusOfSeveralComponentsIsSaidToBeASum) {
  Analysis analysis;
  analysis.characteristics.components = 4;
  analysis.characteristics.genus.value = 3;
  EXPECT_THAT(report_of(analysis), HasLine("genus: 3 (the sum of 4 components)"));
}

TEST(TextReport, UnweldedPairsAreToldApart) {
  Analysis analysis;
  analysis.characteristics.intersecting_pairs = 85;
  analysis.characteristics.unwelded_pairs = 3;
  EXPECT_THAT(report_of(analysis), HasLine("intersecting pairs: 85 (of these unwelded: 3)"));
}

TEST(TextReport, BrokenNumberingShowsTheOffenderAmongItsNeighbours) {
  Analysis analysis;
  analysis.integrity.contiguous_vertices = false;
  analysis.offenders.vertex_numbering = NumberingBreak{{1, 2, 4, 5, 6}, 2};
  const std::string report = report_of(analysis);
  EXPECT_THAT(report,
              HasLine("contiguous vertex numbering: no (first offender in brackets: 1 2 [4] 5 6)"));
  EXPECT_THAT(report, HasLine("contiguous face numbering: yes"));
}

TEST(TextReport, MergedPointsAndFannedPolygonsAreTold) {
  Analysis analysis;
  EXPECT_THAT(report_of(analysis), Not(HasSubstr("merged points")));
  EXPECT_THAT(report_of(analysis), Not(HasSubstr("polygons")));
  analysis.format = Format::Stl;
  analysis.n_merged_points = 28;
  analysis.n_polygons = 6;
  EXPECT_THAT(report_of(analysis), HasSubstr("\nmerged points: 28 (bit-identical"));
  EXPECT_THAT(report_of(analysis), HasSubstr("\npolygons: 6 (each fanned"));
}

TEST(TextReport, StatisticsHaveOneFigureALine) {
  Analysis analysis;
  std::vector<double> areas{1, 2, 3};
  analysis.characteristics.face_area = summarize(areas);
  const std::string report = report_of(analysis);
  EXPECT_THAT(report, HasLine("face area min: 1"));
  EXPECT_THAT(report, HasLine("face area max: 3"));
  EXPECT_THAT(report, HasLine("face area mean: 2"));
  EXPECT_THAT(report, HasLine("face area median: 2"));
  EXPECT_THAT(report, HasLine("face area variance: 1"));
  EXPECT_THAT(report, HasLine("face area total: 6"));
}

TEST(TextReport, NegativeZeroIsZero) {
  Analysis analysis;
  analysis.characteristics.bounding_box = Box3(Vec3(-0.0, -0.0, -1), Vec3(1, 1, 1));
  EXPECT_THAT(report_of(analysis), HasLine("bounding box min: 0 0 -1"));
}

TEST(TextReport, InfiniteValuesAreCountedApart) {
  Analysis analysis;
  std::vector<double> ratios{2, std::numeric_limits<double>::infinity()};
  analysis.characteristics.aspect_ratio = summarize(ratios);
  const std::string report = report_of(analysis);
  EXPECT_THAT(report, HasLine("aspect ratio infinite: 1 (left out of the figures below)"));
  EXPECT_THAT(report, HasLine("aspect ratio max: 2"));
}

TEST(TextReport, HistogramHasTwoBinsALine) {
  Analysis analysis;
  // Bins of width 1 from 0 to 16: one value in the first, two in the last.
  std::vector<double> areas{0, 15.5, 16};
  analysis.characteristics.face_area = summarize(areas);
  const std::string report = report_of(analysis);
  EXPECT_THAT(report, HasLine("   0 ..  1: 1    |     8 ..  9: 0"));
  EXPECT_THAT(report, HasLine("   7 ..  8: 0    |    15 .. 16: 2"));
}

TEST(TextReport, HistogramOfANarrowRangeKeepsItsEdgesApart) {
  Analysis analysis;
  std::vector<double> lengths{1000000, 1000001};
  analysis.characteristics.edge_length = summarize(lengths);
  // Bins of width 1/16: nine digits tell 1000000.0625 from its neighbours, eight do not.
  EXPECT_THAT(report_of(analysis), HasSubstr("1000000 .. 1000000.06: 1"));
}

TEST(TextReport, StatisticsOfEqualValuesHaveNoHistogram) {
  Analysis analysis;
  std::vector<double> areas{0.5, 0.5};
  analysis.characteristics.face_area = summarize(areas);
  EXPECT_THAT(report_of(analysis), HasLine("face area histogram: none (all values are the same)"));
}

TEST(TextReport, ComponentsBeyondTheFirstTwentyAreOnlyCounted) {
  Analysis analysis;
  analysis.components.resize(22);
  const std::string report = report_of(analysis);
  EXPECT_THAT(report, HasLine("components, one a row: the first 20 of 22"));
  EXPECT_THAT(report, HasLine("components not shown: 2 (the JSON report has them all)"));
  analysis.components.resize(20);
  EXPECT_THAT(report_of(analysis), HasLine("components, one a row: all"));
  EXPECT_THAT(report_of(analysis), Not(HasSubstr("not shown")));
}

TEST(TextReport, ComponentsHaveAtLeastSoManyPairsWhereTheSearchWasStopped) {
  Analysis analysis;
  analysis.components.resize(2);
  EXPECT_THAT(report_of(analysis), HasSubstr("  volume  intersecting pairs\n"));
  analysis.characteristics.is_search_stopped = true;
  EXPECT_THAT(report_of(analysis), HasSubstr("  volume  intersecting pairs (at least)\n"));
}

TEST(TextReport, LoneComponentHasNoTable) {
  Analysis analysis;
  analysis.components.resize(1);
  EXPECT_THAT(report_of(analysis), Not(HasSubstr("one a row")));
}

TEST(TextReport, AttributesOnlyIsOneSectionWithTheFile) {
  Analysis analysis;
  analysis.path = "a.mesh";
  analysis.has_characteristics = false;
  EXPECT_EQ(report_of(analysis),
            "MESH ATTRIBUTES\nfile: a.mesh\nclosed: undefined\nmanifold: undefined\norientable: "
            "undefined\n"
            "consistent: undefined\noutward: undefined\n");
}

TEST(TextReport, VerdictAloneIsOneCharacter) {
  Analysis analysis;
  analysis.goodness = Goodness{true, {}};
  EXPECT_EQ(report_of(analysis), "1\n");
  analysis.goodness = Goodness{false, {"not closed"}};
  EXPECT_EQ(report_of(analysis), "0\n");
}

TEST(TextReport, VerdictWithOffendersIsASentenceWithEveryReason) {
  Analysis analysis;
  analysis.goodness = Goodness{false, {"not closed", "2 orphan vertices"}};
  EXPECT_EQ(
      text_report(analysis, OffenderStyle::Ids),
      "mesh is NOT good\nreason: not closed\nreason: 2 orphan vertices\n\nOFFENDING ELEMENTS\n"
      "offending elements: none\n");
  analysis.goodness = Goodness{true, {}};
  EXPECT_THAT(text_report(analysis, OffenderStyle::Ids), testing::StartsWith("mesh is good\n"));
}

}  // namespace
}  // namespace meshalyzer
