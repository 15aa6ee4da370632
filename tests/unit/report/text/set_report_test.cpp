#include "meshalyzer/report/text/set_report.h"

#include "has_line.h"
#include "meshalyzer/report/text/lines.h"
#include "sample_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace meshalyzer {
namespace {

using test::HasLine;
using testing::HasSubstr;
using testing::Not;

std::string report_of(const SetAnalysis& set) {
  return text_report(set, OffenderStyle::None);
}

TEST(SetTextReport, SectionsStandInOrder) {
  const std::string report = report_of(sample_set());
  const std::size_t between = report.find("\n\nINTERSECTIONS BETWEEN MESHES\n");
  const std::size_t separation = report.find("\n\nSEPARATION DISTANCES\n");
  EXPECT_EQ(report.find("MESH SET\n"), 0U);
  EXPECT_LT(between, separation);
  EXPECT_NE(separation, std::string::npos);
}

TEST(SetTextReport, EachTotalStandsUnderItsName) {
  const std::string report = report_of(sample_set());
  EXPECT_THAT(report, HasLine("meshes: 3"));
  EXPECT_THAT(report, HasLine("unreadable files: 1"));
  EXPECT_THAT(report, HasLine("total vertices: 10"));
  EXPECT_THAT(report, HasLine("total faces: 11"));
  EXPECT_THAT(report, HasLine("total edges: 12"));
  EXPECT_THAT(report, HasLine("total components: 13"));
  EXPECT_THAT(report, HasLine("total boundaries: 14"));
  EXPECT_THAT(report, HasLine("total intersecting pairs within meshes: 15"));
  EXPECT_THAT(report, HasLine("total area: 2.5"));
  EXPECT_THAT(report, HasLine("total volume: 1.5 (meshes without a volume: 1)"));
}

TEST(SetTextReport, VolumeThatNoMeshHasIsUndefined) {
  SetAnalysis set;
  set.volume.reason = "meshes without a volume: 1";
  EXPECT_THAT(report_of(set), HasLine("total volume: undefined (meshes without a volume: 1)"));
}

TEST(SetTextReport, MeshesThatAreNotGoodAreNamedWithEveryReason) {
  const std::string report = report_of(sample_set());
  EXPECT_THAT(report, HasLine("good meshes: 2 of 3"));
  EXPECT_THAT(report, HasLine("not good: b.mesh: not closed; 2 orphan vertices"));
  EXPECT_THAT(report, HasLine("not good: torn.mesh: cannot be read: torn"));
  EXPECT_THAT(report,
              testing::HasSubstr("\nverdict: NOT good: 1 mesh is not good; 1 file cannot be read"));
}

TEST(SetTextReport, SetWithoutAFaultIsGood) {
  SetAnalysis set;
  set.good = 2;
  set.intersections.emplace();
  EXPECT_THAT(report_of(set), HasLine("verdict: good"));
}

TEST(SetTextReport, PartBetweenMeshesBeginsWithTheVerdict) {
  SetAnalysis set = sample_set();
  EXPECT_EQ(text_report_between(set, OffenderStyle::None)
                .find("MESH SET\n"
                      "verdict: NOT good: 1 mesh is not good; 1 file cannot be read; "
                      "5 pairs of faces of different meshes intersect; "
                      "1 mesh is inside another one; 2 meshes are partly inside another one\n\n"
                      "INTERSECTIONS BETWEEN MESHES\n"),
            0U);
  set.good.reset();
  EXPECT_EQ(text_report_between(set, OffenderStyle::None).find("INTERSECTIONS BETWEEN MESHES\n"),
            0U);
}

TEST(SetTextReport, PartBetweenMeshesIsEmptyWhereNothingBetweenThemWasAskedFor) {
  SetAnalysis set = sample_set();
  set.intersections.reset();
  set.separation.reset();
  EXPECT_EQ(text_report_between(set, OffenderStyle::None), "");
}

TEST(SetTextReport, SetThatWasNotJudgedIsNeitherGoodNorNot) {
  EXPECT_THAT(report_of(SetAnalysis{}), Not(HasSubstr("good")));
}

TEST(SetTextReport, StatisticsAreThoseOfAMesh) {
  const std::string report = report_of(sample_set());
  EXPECT_THAT(report, HasLine("face area min: 1"));
  EXPECT_THAT(report, HasLine("face area total: 6"));
  EXPECT_THAT(report, HasLine("edge length: undefined (no edge)"));
}

TEST(SetTextReport, WhatOnlyAttributesLeaveOutIsLeftOut) {
  SetAnalysis set;
  set.is_measured = false;
  const std::string report = report_of(set);
  EXPECT_THAT(report, HasLine("total boundaries: 0"));
  for (const char* name : {"within meshes", "area", "volume", "edge angle"}) {
    EXPECT_THAT(report, Not(HasSubstr(name)));
  }
}

TEST(SetTextReport, MeshesThatIntersectHaveARowWithTheKindsThatOccur) {
  const std::string report = report_of(sample_set());
  EXPECT_THAT(report, HasLine("intersecting pairs between meshes: 5"));
  EXPECT_THAT(report, HasLine("pairs of meshes that intersect: 3"));
  EXPECT_THAT(report,
              HasSubstr("pairs of meshes that intersect, one a row: all\n"
                        "  mesh    and mesh  pairs  coplanar-overlap  crossing  touching\n"
                        "  a.mesh  b.mesh        3                 0         2         1\n"
                        "  a.mesh  c.off         1                 0         0         1\n"
                        "  b.mesh  c.off         1                 1         0         0\n"));
}

TEST(SetTextReport, ContainedMeshesAreAlwaysNamed) {
  const std::string report = report_of(sample_set());
  EXPECT_THAT(report, HasLine("contained meshes: 1"));
  EXPECT_THAT(report, HasLine("partly contained meshes: 2"));
  EXPECT_THAT(report, HasLine("contained mesh: c.off inside a.mesh"));
  EXPECT_THAT(report, HasLine("partly contained mesh: components of b.mesh inside c.off"));
}

TEST(SetTextReport, SearchThatWasStoppedHasFoundAtLeastSoMuch) {
  SetAnalysis set = sample_set();
  set.intersections->is_search_stopped = true;
  const std::string report = text_report(set, OffenderStyle::Ids);
  EXPECT_THAT(report, HasLine("intersecting pairs between meshes: at least 5 (the search ended at "
                              "its time limit)"));
  EXPECT_THAT(report, HasLine("pairs of meshes that intersect: at least 3"));
  EXPECT_THAT(report, HasLine("contained meshes: at least 1"));
  EXPECT_THAT(report, HasLine("partly contained meshes: at least 2"));
  EXPECT_THAT(report, HasSubstr("pairs of meshes that intersect, one a row: those found within the "
                                "time limit\n  mesh    and mesh  pairs (at least)  "));
  EXPECT_THAT(report, HasLine("offending intersecting pairs between meshes: at least 5"));
  EXPECT_THAT(report, HasLine("total intersecting pairs within meshes: 15"));
}

TEST(SetTextReport, SearchWithinAMeshThatWasStoppedMakesTheTotalALowerBound) {
  SetAnalysis set = sample_set();
  set.is_search_within_stopped = true;
  EXPECT_THAT(report_of(set), HasLine("total intersecting pairs within meshes: at least 15"));
  EXPECT_THAT(report_of(set), HasLine("total faces: 11"));
  EXPECT_THAT(report_of(set), HasLine("contained meshes: 1"));
}

TEST(SetTextReport, PairsOfFacesAreNamedWhenAsked) {
  const std::string pair = "a.mesh face 3, b.mesh face 18: touching";
  EXPECT_THAT(report_of(sample_set()), Not(HasSubstr(" face 18")));
  EXPECT_THAT(text_report(sample_set(), OffenderStyle::Ids), HasLine(pair));
  EXPECT_EQ(text_report(sample_set(), OffenderStyle::CustomPoints),
            text_report(sample_set(), OffenderStyle::Ids));
}

TEST(SetTextReport, MeshesThatKeepApartHaveNoTable) {
  SetAnalysis set = sample_set();
  set.intersections.emplace();
  const std::string report = text_report(set, OffenderStyle::Ids);
  EXPECT_THAT(report, HasLine("intersecting pairs between meshes: 0"));
  EXPECT_THAT(report, Not(HasSubstr("one a row")));
  EXPECT_THAT(report, Not(HasSubstr("offending")));
}

TEST(SetTextReport, SeparationHasItsFiguresAndARowAMesh) {
  const std::string report = report_of(sample_set());
  EXPECT_THAT(report, HasLine("separation distance count: 5"));
  EXPECT_THAT(report, HasLine("separation distance min: -1"));
  EXPECT_THAT(report, HasLine("separation distance histogram: 16 bins of equal width"));
  EXPECT_THAT(report, HasLine("vertices inside another mesh: 1"));
  // Means (-1 + 2 + 2) / 3 and (3 + 5) / 2.
  EXPECT_THAT(report,
              HasSubstr("  mesh    vertices  min  mean  median  max  inside  without closest\n"
                        "  a.mesh         3   -1     1       2    2       1                0\n"
                        "  b.mesh         6    3     4       4    5       0                4\n"
                        "  c.off          6    -     -       -    -       0                6\n"));
}

TEST(SetTextReport, SeparationTellsItsOptionsAndWhatTheyKeptOut) {
  SetAnalysis set = sample_set();
  EXPECT_THAT(report_of(set), HasLine("vertices without a closest point: 10 (no other mesh)"));
  EXPECT_THAT(report_of(set), Not(HasSubstr("search")));
  set.separation->options.search_radius = 2.5;
  EXPECT_THAT(report_of(set), HasLine("search radius: 2.5"));
  EXPECT_THAT(report_of(set), HasSubstr("10 (nothing within the search radius)\n"));
  set.separation->options.search_cone_degrees = 30;
  EXPECT_THAT(report_of(set), HasLine("search cone: 30 degrees round the vertex normal"));
  EXPECT_THAT(report_of(set), HasSubstr("10 (nothing within the search radius and cone)\n"));
  set.separation->options.search_radius.reset();
  EXPECT_THAT(report_of(set), HasSubstr("10 (nothing within the search cone)\n"));
  set.separation->options.include_self = 4;
  EXPECT_THAT(report_of(set), HasLine("include self: own faces farther than 4 along edges"));
  set.separation->without_closest = 0;
  EXPECT_THAT(report_of(set), HasLine("vertices without a closest point: 0"));
}

TEST(SetTextReport, ForcedSeparationSaysSo) {
  SetAnalysis set = sample_set();
  EXPECT_THAT(report_of(set), Not(HasSubstr("forced")));
  set.separation->is_forced = true;
  EXPECT_THAT(report_of(set), HasLine("forced: yes (not every mesh is good)"));
}

TEST(SetTextReport, SeparationThatWasNotMeasuredTellsWhy) {
  SetAnalysis set = sample_set();
  set.separation.reset();
  EXPECT_THAT(report_of(set), Not(HasSubstr("SEPARATION")));
  set.separation_reason = "b.mesh is not good";
  EXPECT_THAT(report_of(set), HasLine("separation distances: not measured: b.mesh is not good"));
}

TEST(SetTextReport, ColumnsAreAlignedByCharactersNotBytes) {
  SetAnalysis set = sample_set();
  set.names[0] = "\xC3\xA4.mesh";  // two bytes, one character
  EXPECT_THAT(report_of(set), HasSubstr("  \xC3\xA4.mesh         3   -1     1       2    2"));
  EXPECT_THAT(report_of(set), HasSubstr("  b.mesh         6    3     4       4    5"));
}

TEST(LineSink, CountsHaveTheirDigitsInGroupsOnPagesAlone) {
  TextLines lines;
  lines.line("faces", std::size_t{16937291});
  EXPECT_EQ(lines.text(), "faces: 16937291\n");
  ReportRows rows;
  rows.line("faces", std::size_t{16937291});
  rows.line("genus", -1000);
  EXPECT_EQ(rows.rows()[0].value, "16,937,291");
  EXPECT_EQ(rows.rows()[1].value, "-1000");
}

}  // namespace
}  // namespace meshalyzer
