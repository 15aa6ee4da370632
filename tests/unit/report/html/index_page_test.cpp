#include "meshalyzer/report/html/index_page.h"

#include "sample_set.h"
#include "support/html_faults.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

using test::html_faults;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<IndexRow> sample_rows() {
  IndexRow good{.name = "a.mesh", .page = "set_pages/a.html"};
  good.good = true;
  good.vertices = 8;
  good.faces = 12;
  good.area = 6.0;
  good.volume = 1.0;
  IndexRow bad{.name = "b.mesh", .page = "set_pages/b.html"};
  bad.reasons = {"not closed", "2 orphan vertices"};
  bad.vertices = 100;
  bad.faces = 1000;
  bad.defects[static_cast<std::size_t>(DefectCode::Hole)] = 7;
  IndexRow torn{.name = "torn.mesh", .page = ""};
  torn.error = "torn.mesh:3: no number";
  return {good, bad, torn};
}

TEST(HtmlIndex, PageIsWellFormed) {
  const SetAnalysis set = sample_set();
  EXPECT_THAT(html_faults(html_index(sample_rows(), nullptr)), IsEmpty());
  EXPECT_THAT(html_faults(html_index(sample_rows(), &set)), IsEmpty());
  EXPECT_THAT(html_faults(html_index({}, nullptr)), IsEmpty());
}

TEST(HtmlIndex, EachMeshHasARowWithALinkToItsPage) {
  const std::string html = html_index(sample_rows(), nullptr);
  EXPECT_THAT(html, HasSubstr("<a href=\"set_pages/a.html\">a.mesh</a>"));
  EXPECT_THAT(html, HasSubstr("<td class=\"name state good\">good</td>"
                              "<td class=\"name why\"></td><td class=\"number\">0</td>"
                              "<td class=\"number\">12</td><td class=\"number\">8</td>"
                              "<td class=\"number\">6</td><td class=\"number\">1</td>"));
  EXPECT_THAT(html, HasSubstr("not good</td>"));
  EXPECT_THAT(html, HasSubstr("not closed; 2 orphan vertices"));
}

TEST(HtmlIndex, FileThatCannotBeReadHasItsMessageAndNoLink) {
  const std::string html = html_index(sample_rows(), nullptr);
  EXPECT_THAT(html, HasSubstr("class=\"name\">torn.mesh</th>"));
  EXPECT_THAT(html, HasSubstr("unreadable</td>"));
  EXPECT_THAT(html, HasSubstr("torn.mesh:3: no number"));
}

TEST(HtmlIndex, OnlyCodesThatOccurHaveAColumn) {
  const std::string html = html_index(sample_rows(), nullptr);
  EXPECT_THAT(html, HasSubstr(">hole</th>"));
  EXPECT_THAT(html, HasSubstr("<td class=\"number found\">7</td>"));
  EXPECT_THAT(html, Not(HasSubstr(">slit</th>")));
  EXPECT_THAT(html, Not(HasSubstr("smallest separation")));
  std::vector<IndexRow> rows = sample_rows();
  rows[0].separation = 0.25;
  EXPECT_THAT(html_index(rows, nullptr), HasSubstr("<td class=\"number\">0.25</td>"));
}

TEST(HtmlIndex, AllDefectsOfAMeshAreCountedBesideWhyItIsNotGood) {
  std::vector<IndexRow> rows = sample_rows();
  rows[1].defects[static_cast<std::size_t>(DefectCode::Slit)] = 4;
  EXPECT_THAT(html_index(rows, nullptr),
              HasSubstr("<td class=\"name why\">not closed; 2 orphan vertices</td>"
                        "<td class=\"number found\">11</td><td class=\"number\">1,000</td>"));
}

TEST(HtmlIndex, DefectsThatAreNoErrorsAreNotShownAsSuch) {
  IndexRow row = sample_rows()[0];
  row.defects[static_cast<std::size_t>(DefectCode::Disjoint)] = 3;
  const std::string html = html_index({row}, nullptr);
  EXPECT_THAT(html, HasSubstr("<td class=\"number warned\">3</td>"));
  EXPECT_THAT(html, Not(HasSubstr("number found")));
}

TEST(HtmlIndex, MeshThatMeetsOthersIsSaidTo) {
  const SetAnalysis set = sample_set();
  const std::string html = html_index(sample_rows(), &set);
  EXPECT_THAT(html, HasSubstr("intersects b.mesh, c.off; partly inside c.off</td>"));
  EXPECT_THAT(html, HasSubstr("not closed; 2 orphan vertices; intersects a.mesh, c.off; "
                              "partly inside c.off</td>"));
}

TEST(HtmlIndex, VerdictCountsWhatIsNotGood) {
  const std::string html = html_index(sample_rows(), nullptr);
  EXPECT_THAT(html, HasSubstr("verdict bad"));
  EXPECT_THAT(html, HasSubstr("<li>1 mesh is not good</li>"));
  EXPECT_THAT(html, HasSubstr("<li>1 file cannot be read</li>"));
  EXPECT_THAT(html, HasSubstr("2 meshes, 1,012 faces, 108 vertices"));
  EXPECT_THAT(html_index({sample_rows()[0]}, nullptr), HasSubstr("verdict good"));
}

TEST(HtmlIndex, GoodMeshesThatMeetAreNotAGoodSet) {
  const SetAnalysis set = sample_set();
  const std::string html = html_index({sample_rows()[0]}, &set);
  EXPECT_THAT(html, HasSubstr("good only by itself</td>"));
  EXPECT_THAT(html, HasSubstr("verdict bad"));
  EXPECT_THAT(html, HasSubstr("<li>5 pairs of faces of different meshes intersect</li>"));
  EXPECT_THAT(html, HasSubstr("<li>1 mesh is inside another one</li>"));
}

TEST(HtmlIndex, MeshThatWasNotJudgedHasNoVerdict) {
  const std::string html = html_index({IndexRow{.name = "a", .page = "a.html"}}, nullptr);
  EXPECT_THAT(html, Not(HasSubstr("class=\"verdict")));
  EXPECT_THAT(html, HasSubstr("<td class=\"name\">-</td>"));
}

TEST(HtmlIndex, WhatIsBetweenTheMeshesIsToldWhereItWasAskedFor) {
  const SetAnalysis set = sample_set();
  const std::string html = html_index(sample_rows(), &set);
  EXPECT_THAT(html, HasSubstr("<td>c.off inside a.mesh</td>"));
  EXPECT_THAT(html, HasSubstr("id=\"between\""));
  EXPECT_THAT(html, HasSubstr(">coplanar-overlap</th>"));
  EXPECT_THAT(html, HasSubstr("id=\"separation\""));
  EXPECT_THAT(html, HasSubstr("Histogram of separation distance from -1 to 5"));
  EXPECT_THAT(html, HasSubstr("1.5 (meshes without a volume: 1)"));
  SetAnalysis unasked;
  unasked.separation_reason = "b.mesh is not good";
  const std::string without = html_index(sample_rows(), &unasked);
  EXPECT_THAT(without, Not(HasSubstr("id=\"between\"")));
  EXPECT_THAT(without, HasSubstr("Not measured: b.mesh is not good"));
}

TEST(HtmlIndex, HostileNamesAreOnlyText) {
  std::vector<IndexRow> rows = sample_rows();
  rows[0].name = "<b>&\"x.obj";
  rows[0].page = "p/<b>&\"x.html";
  rows[1].reasons = {"</table><script>alert(1)</script>"};
  rows[2].name = "\xFF\x01";
  const std::string html = html_index(rows, nullptr);
  EXPECT_THAT(html_faults(html), IsEmpty());
  EXPECT_THAT(html, HasSubstr("<a href=\"p/%3Cb%3E%26%22x.html\">&lt;b&gt;&amp;&quot;x.obj</a>"));
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
}

TEST(HtmlIndex, PageIsSmallAndFetchesNothing) {
  const std::string html = html_index(sample_rows(), nullptr);
  EXPECT_LT(html.size(), 100'000U);
  EXPECT_THAT(html, Not(HasSubstr("http:")));
  EXPECT_THAT(html, Not(HasSubstr(" src=")));
}

TEST(IndexRowOf, VerdictIsThatOfGoodnessElseOfFitness) {
  Analysis analysis;
  analysis.fitness = Goodness{true, {}};
  EXPECT_TRUE(index_row(analysis, {}, "a", "a.html").good);
  analysis.goodness = Goodness{false, {"thin"}};
  const IndexRow row = index_row(analysis, {}, "a", "a.html");
  EXPECT_FALSE(row.good);
  EXPECT_EQ(row.reasons, std::vector<std::string>{"thin"});
}

TEST(IndexRowOf, MeasuresAreThereWhereTheyWereTaken) {
  Analysis analysis;
  analysis.characteristics.faces = 12;
  analysis.characteristics.vertices = 8;
  analysis.characteristics.area = 6.0;
  analysis.characteristics.volume.value = 1.0;
  DefectReport defects;
  defects.counts[3] = 4;
  const IndexRow row = index_row(analysis, defects, "a", "p/a.html");
  EXPECT_EQ(row.name, "a");
  EXPECT_EQ(row.page, "p/a.html");
  EXPECT_EQ(row.faces, 12U);
  EXPECT_EQ(row.vertices, 8U);
  EXPECT_EQ(row.area, 6.0);
  EXPECT_EQ(row.volume, 1.0);
  EXPECT_EQ(row.defects[3], 4U);
  analysis.has_characteristics = false;
  EXPECT_EQ(index_row(analysis, defects, "a", "p/a.html").area, std::nullopt);
}

}  // namespace
}  // namespace meshalyzer
