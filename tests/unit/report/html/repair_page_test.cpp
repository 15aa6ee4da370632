#include "meshalyzer/report/html/repair_page.h"

#include "html/sample_scene.h"
#include "sample_repair.h"
#include "support/html_faults.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

using test::html_faults;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string page_of(const RepairReport& report) {
  const Scene scene = sample_scene();
  const DefectReport defects = sample_defects();
  const MeshName& after = report.meshes.front().name;
  return html_report(RepairPage{
      report, {report.input, defects, scene}, {after, report.meshes.front().remaining, Scene{}}});
}

RepairResult result_with_a_step() {
  RepairResult result = sample_result();
  LogStep step;
  step.pass = "weld borders";
  step.operations = 2;
  step.faces_changed = 1;
  step.distance = 0.125;
  result.log.steps = {step};
  result.before = sample_defects();
  return result;
}

TEST(HtmlReportOfRepair, PageIsWellFormed) {
  const RepairResult result = sample_result();
  EXPECT_THAT(html_faults(page_of(sample_report(result))), IsEmpty());
}

TEST(HtmlReportOfRepair, WhatWasDoneIsToldPassByPass) {
  const RepairResult result = result_with_a_step();
  const std::string html = page_of(sample_report(result));
  EXPECT_THAT(html_faults(html), IsEmpty());
  EXPECT_THAT(html, HasSubstr("<title>in.mesh: repaired</title>"));
  EXPECT_THAT(html, HasSubstr("class=\"name\">weld borders</th>"
                              "<td class=\"name\">2 changes, 1 face changed"));
  EXPECT_THAT(html, HasSubstr("</td><td class=\"number\">2</td><td class=\"number\">0.125</td>"));
}

TEST(HtmlReportOfRepair, CountsHaveTheirDigitsInGroups) {
  const RepairResult result = sample_result();
  RepairReport report = sample_report(result);
  report.input.n_faces = 12'345;
  EXPECT_THAT(page_of(report), HasSubstr("<td>12,345 \u2192 3</td>"));
}

TEST(HtmlReportOfRepair, NothingToDoIsSaid) {
  const RepairResult result = sample_result();
  const std::string html = page_of(sample_report(result));
  EXPECT_THAT(html, HasSubstr("Nothing was changed."));
  EXPECT_THAT(html, HasSubstr("role=\"status\">Nothing was to be done</p>"));
  EXPECT_THAT(html, Not(HasSubstr("id=\"refusals\"")));
}

TEST(HtmlReportOfRepair, WhatWasNotAskedForAndRemainsIsNamedBesideTheVerdict) {
  const RepairResult result = result_with_a_step();
  RepairReport report = sample_report(result);
  report.meshes.front().remaining = sample_defects();
  report.fixes = {DefectCode::Flipped};
  EXPECT_THAT(page_of(report), HasSubstr("Repaired</p>\n<ul class=\"reasons\">"));
  EXPECT_THAT(page_of(report), HasSubstr("<li>hole: 1 (not asked for)</li>"));
}

TEST(HtmlReportOfRepair, CountsStandBeforeAndAfter) {
  const RepairResult result = result_with_a_step();
  RepairReport report = sample_report(result);
  add_defect(report.meshes[0].remaining, DefectCode::DuplicateFacet);
  add_defect(report.meshes[0].remaining, DefectCode::Disjoint);
  const std::string html = page_of(report);
  EXPECT_THAT(html, HasSubstr("class=\"name\">duplicate-facet</th><td class=\"name\">yes</td>"
                              "<td class=\"number\">3</td><td class=\"number\">1</td>"));
  EXPECT_THAT(html, HasSubstr("class=\"name\">disjoint</th><td class=\"name\">no</td>"
                              "<td class=\"number\">0</td><td class=\"number\">1</td>"));
  EXPECT_THAT(html, HasSubstr("role=\"status\">1 defect remains</p>"));
  EXPECT_THAT(html, HasSubstr("<li>duplicate-facet: 1</li>"));
  EXPECT_THAT(html, Not(HasSubstr("<li>disjoint: 1</li>")));
}

TEST(HtmlReportOfRepair, WhatWasLeftHasItsReason) {
  RepairResult result = sample_result();
  result.log.refusals = {{.pass = "fill holes",
                          .code = DefectCode::Hole,
                          .vertex = 0,
                          .face = kNoIndex,
                          .reason = "no patch < fits"}};
  const std::string html = page_of(sample_report(result));
  EXPECT_THAT(html, HasSubstr("id=\"refusals\""));
  EXPECT_THAT(html, HasSubstr("left by fill holes"));
  EXPECT_THAT(html, HasSubstr("no patch &lt; fits"));
}

TEST(HtmlReportOfRepair, NotesAndBothMeshesAreThere) {
  const RepairResult result = sample_result();
  RepairReport report = sample_report(result);
  report.notes = {"something <to> know"};
  const std::string html = page_of(report);
  EXPECT_THAT(html, HasSubstr("something &lt;to&gt; know"));
  EXPECT_THAT(html, HasSubstr("<h3>before</h3>"));
  EXPECT_THAT(html, HasSubstr("<h3>after</h3>"));
  EXPECT_THAT(html, HasSubstr("\"title\": \"before\""));
  EXPECT_THAT(html, HasSubstr("\"title\": \"after\""));
}

}  // namespace
}  // namespace meshalyzer
