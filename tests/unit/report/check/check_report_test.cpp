#include "meshalyzer/report/check/check_report.h"

#include "meshalyzer/report/json/tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace meshalyzer {
namespace {

/// A mesh that is not good, with more findings than are listed.
FileFindings bad_file() {
  FileFindings file;
  file.path = "a b.obj";
  file.faces = 12;
  file.counts = {{.code = "hole", .severity = Severity::Error, .count = 36, .fixable = 36},
                 {.code = "orphan-vertex", .severity = Severity::Warning, .count = 1}};
  file.findings = {{.code = "hole",
                    .severity = Severity::Error,
                    .message = "a border, 50% <long>",
                    .fix = "meshfixer fills it",
                    .line = 628,
                    .vertices = {3, 4},
                    .faces = {},
                    .position = Vec3(1, 2, 3),
                    .value = 0.5,
                    .is_at_least = true,
                    .limit = std::nullopt},
                   {.code = "orphan-vertex",
                    .severity = Severity::Warning,
                    .message = "no face uses vertex 9",
                    .fix = "",
                    .line = std::nullopt,
                    .vertices = {9},
                    .faces = {},
                    .position = std::nullopt,
                    .value = std::nullopt,
                    .limit = std::nullopt}};
  return file;
}

FileFindings unreadable_file() {
  FileFindings file;
  file.path = "b.ply";
  file.error = "no face";
  file.error_place.line = 7;
  return file;
}

FileFindings good_file() {
  FileFindings file;
  file.path = "c.stl";
  return file;
}

std::string report_as(CheckFormat format, TextColour colour = TextColour::Never) {
  std::string text;
  CheckTotals totals;
  const auto report = make_check_report(
      format, [&](std::string_view piece) { text += piece; }, colour);
  for (const FileFindings& file : {bad_file(), unreadable_file(), good_file()}) {
    report->add(file);
    totals.add(file);
  }
  report->finish(totals, std::chrono::duration<double>(6.12));
  return text;
}

TEST(CheckReport, TextTellsAFindingALineAndTheTotalsLast) {
  EXPECT_EQ(report_as(CheckFormat::Text),
            "a b.obj:628: error[hole]: a border, 50% <long> (meshfixer fills it)\n"
            "a b.obj: ... and 35 more hole\n"
            "a b.obj: warning[orphan-vertex]: no face uses vertex 9\n"
            "b.ply:7: error[unreadable]: no face\n"
            "3 meshes in 6.1 s: 1 good, 1 not (36 errors, 1 warning; 36 fixable), 1 unreadable\n");
}

TEST(CheckReport, TextTellsThatThereMayBeMoreThanIsListed) {
  FileFindings file = bad_file();
  file.counts[1].is_at_least = true;
  std::string text;
  const auto report = make_check_report(
      CheckFormat::Text, [&](std::string_view piece) { text += piece; }, TextColour::Never);
  report->add(file);
  EXPECT_NE(text.find("a b.obj: ... and perhaps more orphan-vertex\n"), std::string::npos);
  EXPECT_EQ(text.find("at least 0"), std::string::npos);
}

TEST(CheckReport, TextNamesAFileOnOneLine) {
  FileFindings bad = bad_file();
  FileFindings unreadable = unreadable_file();
  for (FileFindings* file : {&bad, &unreadable}) file->path = "a\nb.obj";
  std::string text;
  const auto report = make_check_report(
      CheckFormat::Text, [&](std::string_view piece) { text += piece; }, TextColour::Never);
  report->add(bad);
  report->add(unreadable);
  EXPECT_EQ(text,
            "a?b.obj:628: error[hole]: a border, 50% <long> (meshfixer fills it)\n"
            "a?b.obj: ... and 35 more hole\n"
            "a?b.obj: warning[orphan-vertex]: no face uses vertex 9\n"
            "a?b.obj:7: error[unreadable]: no face\n");
}

TEST(CheckReport, TextOnATerminalColoursSeverities) {
  const std::string text = report_as(CheckFormat::Text, TextColour::Always);
  EXPECT_NE(text.find("\x1b[1;31merror\x1b[0m[hole]"), std::string::npos);
  EXPECT_NE(text.find("\x1b[1;33mwarning\x1b[0m[orphan-vertex]"), std::string::npos);
}

TEST(CheckReport, JsonHoldsFindingsCountsAndErrors) {
  const std::string text = report_as(CheckFormat::Json);
  const JsonTree tree(text);
  JsonElements meshes = tree.root().member("meshes").elements();
  const JsonNode bad = meshes.next();
  EXPECT_FALSE(bad.member("good").truth());
  EXPECT_EQ(bad.member("counts").elements().next().member("count").count(), 36U);
  EXPECT_EQ(bad.member("findings").elements().next().member("line").count(), 628U);
  EXPECT_TRUE(bad.member("findings").elements().next().member("at_least").truth());
  EXPECT_TRUE(bad.member("error").is_null());
  const JsonNode unreadable = meshes.next();
  EXPECT_EQ(unreadable.member("error").member("message").text(), "no face");
  EXPECT_EQ(unreadable.member("error").member("line").count(), 7U);
  EXPECT_FALSE(unreadable.member("good").truth());
  EXPECT_TRUE(meshes.next().member("good").truth());
  EXPECT_EQ(tree.root().member("totals").member("unreadable").count(), 1U);
}

TEST(CheckReport, NdjsonHasALineAFileAndOneOfTotals) {
  const std::string text = report_as(CheckFormat::Ndjson);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
  EXPECT_TRUE(JsonTree(text.substr(text.rfind('\n', text.size() - 2) + 1)).root().find("totals"));
}

TEST(CheckReport, SarifEscapesPathsAndKnowsItsRules) {
  const std::string text = report_as(CheckFormat::Sarif);
  const JsonTree tree(text);
  const JsonNode run = tree.root().member("runs").elements().next();
  JsonElements results = run.member("results").elements();
  const JsonNode hole = results.next();
  EXPECT_EQ(hole.member("ruleId").text(), "hole");
  const JsonNode place = hole.member("locations").elements().next().member("physicalLocation");
  EXPECT_EQ(place.member("artifactLocation").member("uri").text(), "a%20b.obj");
  EXPECT_EQ(place.member("region").member("startLine").count(), 628U);
  std::vector<std::string> rules;
  for (JsonElements rows = run.member("tool").member("driver").member("rules").elements();
       !rows.at_end();) {
    rules.emplace_back(rows.next().member("id").text());
  }
  for (; !results.at_end();) {
    const std::string rule(results.next().member("ruleId").text());
    EXPECT_NE(std::find(rules.begin(), rules.end(), rule), rules.end()) << rule;
  }
  EXPECT_FALSE(run.member("invocations").elements().next().member("executionSuccessful").truth());
}

TEST(CheckReport, JunitCountsCasesAndEscapesMarkup) {
  const std::string text = report_as(CheckFormat::Junit);
  EXPECT_NE(text.find("tests=\"3\" failures=\"1\" errors=\"1\""), std::string::npos);
  EXPECT_NE(text.find("50% &lt;long&gt;"), std::string::npos);
  EXPECT_NE(text.find("<error type=\"unreadable\" message=\"no face\">"), std::string::npos);
  EXPECT_NE(text.find("name=\"c.stl\" time=\"0\"/>"), std::string::npos);
}

TEST(CheckReport, GithubEncodesWhatEndsACommand) {
  const std::string text = report_as(CheckFormat::Github);
  EXPECT_EQ(
      text.substr(0, text.find('\n')),
      "::error file=a b.obj,line=628,title=hole::a border, 50%25 <long> (meshfixer fills it)");
  EXPECT_NE(text.find("::error file=b.ply,line=7,title=unreadable::no face\n"), std::string::npos);
}

TEST(CheckFormat, EveryOneIsFoundByItsName) {
  for (const CheckFormat format : all_check_formats()) {
    EXPECT_EQ(check_format(check_format_name(format)), format);
  }
  EXPECT_EQ(check_format("xml"), std::nullopt);
}

}  // namespace
}  // namespace meshalyzer
