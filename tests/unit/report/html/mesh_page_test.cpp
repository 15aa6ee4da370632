#include "meshalyzer/report/html/mesh_page.h"

#include "html/sample_scene.h"
#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/report/html/defects_page.h"
#include "support/html_faults.h"
#include "support/shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

using test::html_faults;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Analysis analysis_of(const Soup& soup, std::string path = "folder/cube.mesh",
                     const AnalysisOptions& options = {}) {
  return analyze(soup, std::move(path), options);
}

std::string page_of(const Analysis& analysis, const std::string& index = "",
                    const MeshName& name = sample_name("folder/cube.mesh")) {
  const DefectReport defects = sample_defects();
  const Scene scene = sample_scene();
  return html_report(MeshPage{analysis, {name, defects, scene}, index});
}

/// Returns the part of a page before the scripts.
std::string content_of(const std::string& html) {
  return html.substr(0, html.find("<script"));
}

TEST(HtmlReport, PageIsWellFormed) {
  AnalysisOptions options;
  options.curvature = VertexArea::Mixed;
  EXPECT_THAT(html_faults(page_of(analysis_of(shapes::cube(), "cube.mesh", options), "../a.html")),
              IsEmpty());
  EXPECT_THAT(html_faults(page_of(analysis_of({}))), IsEmpty());
}

TEST(HtmlReport, GoodMeshIsSaidToBeGood) {
  const std::string html = page_of(analysis_of(shapes::cube()));
  EXPECT_THAT(html, HasSubstr("<title>cube.mesh: good</title>"));
  EXPECT_THAT(html, HasSubstr("<h1>cube.mesh</h1>"));
  EXPECT_THAT(html, HasSubstr("<p class=\"verdict good\" role=\"status\">Good</p>"));
  EXPECT_THAT(html, Not(HasSubstr("class=\"reasons\"")));
  EXPECT_THAT(html, HasSubstr("<p class=\"facts\">12 faces, 8 vertices, mesh file</p>"));
}

TEST(HtmlReport, EveryReasonAgainstAMeshIsTold) {
  Analysis analysis = analysis_of(shapes::cube());
  analysis.goodness = Goodness{false, {"not closed", "2 < 3 & more"}};
  const std::string html = page_of(analysis);
  EXPECT_THAT(html, HasSubstr("<title>cube.mesh: not good</title>"));
  EXPECT_THAT(html, HasSubstr("<p class=\"verdict bad\" role=\"status\">Not good</p>"));
  EXPECT_THAT(html, HasSubstr("<li>not closed</li>"));
  EXPECT_THAT(html, HasSubstr("<li>2 &lt; 3 &amp; more</li>"));
}

TEST(HtmlReport, WhereOnlyAttributesWereAskedForTheyAreTheVerdict) {
  AnalysisOptions options;
  options.scope = Scope::AttributesOnly;
  const std::string html = page_of(analysis_of(shapes::cube(), "cube.mesh", options));
  EXPECT_THAT(html, HasSubstr(">Closed, manifold, orientable, consistent, outward</p>"));
  EXPECT_THAT(html, Not(HasSubstr("id=\"characteristics\"")));
  EXPECT_THAT(html_faults(html), IsEmpty());
}

TEST(HtmlReport, RowsAreThoseOfTheTextWithDefinitions) {
  const std::string html = page_of(analysis_of(shapes::cube()));
  EXPECT_THAT(html, HasSubstr("<span class=\"term\" tabindex=\"0\" aria-describedby=\"def-closed\">"
                              "closed</span><span class=\"definition\" role=\"tooltip\" "
                              "id=\"def-closed\">"));
  EXPECT_THAT(html, HasSubstr("id=\"def-genus\""));
  EXPECT_THAT(html, HasSubstr("<td>0 (of these unwelded: 0)</td>"));
}

TEST(HtmlReport, AnswerThatThereIsNotHasItsReason) {
  EXPECT_THAT(page_of(analysis_of({})), HasSubstr("<td>undefined (no face)</td>"));
}

TEST(HtmlReport, QuantityOfEqualValuesHasFiguresAndNoHistogram) {
  // All edges of a regular tetrahedron have the same length; a cube has sides and diagonals.
  const std::string html = page_of(analysis_of(shapes::cube()));
  EXPECT_THAT(html, HasSubstr("aria-label=\"Histogram of edge length from 1 to 1.414"));
  EXPECT_THAT(html, Not(HasSubstr("Histogram of face area")));
  EXPECT_THAT(html, HasSubstr("No histogram: all values are the same."));
}

TEST(HtmlReport, CurvatureIsShownWhereItWasMeasured) {
  AnalysisOptions options;
  options.curvature = VertexArea::Barycentric;
  const std::string html = page_of(analysis_of(shapes::cube(), "cube.mesh", options));
  EXPECT_THAT(html, HasSubstr("<td>barycentric</td>"));
  // 2 pi (8 - 18 + 12).
  EXPECT_THAT(html, HasSubstr("<td>12.56637061</td>"));
  EXPECT_THAT(html, HasSubstr(">mean curvature</span>"));
  EXPECT_THAT(page_of(analysis_of(shapes::cube())), Not(HasSubstr("id=\"curvature\"")));
}

TEST(HtmlReport, ComponentsHaveATableWhereThereAreSeveral) {
  EXPECT_THAT(page_of(analysis_of(shapes::cube())), Not(HasSubstr("id=\"components\"")));
  Analysis analysis = analysis_of(shapes::cube());
  analysis.components.resize(102, analysis.components.front());
  const std::string html = page_of(analysis);
  EXPECT_THAT(html, HasSubstr("id=\"components\""));
  EXPECT_THAT(html, HasSubstr("<p class=\"cut\">2 more are not shown.</p>"));
  EXPECT_THAT(html_faults(html), IsEmpty());
}

TEST(HtmlReport, HostileNameIsOnlyText) {
  const std::string path = "<b>&\"x</script>\xFF.obj";
  const std::string html = page_of(analysis_of(shapes::cube(), path), "", sample_name(path));
  EXPECT_THAT(html_faults(html), IsEmpty());
  EXPECT_THAT(html, Not(HasSubstr("<b>")));
  EXPECT_THAT(html, HasSubstr("&lt;b&gt;&amp;&quot;x&lt;/script&gt;�.obj"));
}

TEST(HtmlReport, LinkToTheIndexIsThereInASetAlone) {
  const Analysis analysis = analysis_of(shapes::cube());
  EXPECT_THAT(page_of(analysis, "../my set.html"),
              HasSubstr("<a href=\"../my%20set.html\">All meshes</a>"));
  EXPECT_THAT(page_of(analysis), Not(HasSubstr("<nav>")));
}

TEST(HtmlReport, NothingIsFetched) {
  const std::string content = content_of(page_of(analysis_of(shapes::cube()), "../a.html"));
  EXPECT_THAT(content, Not(HasSubstr("http:")));
  EXPECT_THAT(content, Not(HasSubstr("https:")));
  EXPECT_THAT(content, Not(HasSubstr(" src=")));
  EXPECT_THAT(content, Not(HasSubstr("<link")));
  EXPECT_THAT(content, HasSubstr("default-src 'none'"));
}

TEST(HtmlReport, LicenceStandsBesideTheLibraryItIsOf) {
  const std::string html = page_of(analysis_of(shapes::cube()));
  EXPECT_THAT(html, HasSubstr("MIT License"));
  EXPECT_LT(html.find("MIT License"), html.find("WebGLRenderer"));
}

TEST(HtmlReport, SameInputGivesTheSameBytes) {
  const Analysis analysis = analysis_of(shapes::cube());
  EXPECT_EQ(page_of(analysis), page_of(analysis));
}

TEST(HtmlReport, PageForDefectsJudgesByWhatWasAskedFor) {
  const MeshName name = sample_name();
  const DefectReport defects = sample_defects();
  const Scene scene = sample_scene();
  const PageMesh mesh{name, defects, scene};
  const std::string bad = html_report(mesh, DefectCodes::all());
  EXPECT_THAT(html_faults(bad), IsEmpty());
  EXPECT_THAT(bad, HasSubstr("<title>sample.mesh: 4 defects</title>"));
  EXPECT_THAT(bad, HasSubstr("<li>hole: 1</li>"));
  EXPECT_THAT(bad, HasSubstr("<li>duplicate-facet: 3</li>"));
  EXPECT_THAT(bad, HasSubstr("degeneracy tolerance"));
  const std::string other = html_report(mesh, {DefectCode::Slit});
  EXPECT_THAT(other,
              HasSubstr("verdict good\" role=\"status\">Nothing that was asked for is wrong"));
  const DefectReport none;
  const Scene empty;
  EXPECT_THAT(html_report(PageMesh{name, none, empty}, DefectCodes::all()),
              HasSubstr("verdict good\" role=\"status\">Nothing is wrong<"));
}

}  // namespace
}  // namespace meshalyzer
