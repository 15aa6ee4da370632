#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/report/json/mesh.h"
#include "meshalyzer/report/json/report.h"
#include "meshalyzer/report/json/writer.h"
#include "meshalyzer/report/text/mesh_report.h"
#include "soups_to_try.h"
#include "support/effort.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

std::string line_of(const Analysis& analysis, JsonOffenders offenders) {
  JsonWriter writer;
  writer.begin_object(JsonLayout::Row);
  write_mesh_members(writer, analysis, offenders);
  writer.end_object();
  return writer.take();
}

std::string json_of(const Analysis& analysis, JsonOffenders offenders) {
  return json_report({&analysis, 1}, nullptr, offenders);
}

void expect_same_verdict(const std::optional<Goodness>& actual,
                         const std::optional<Goodness>& expected) {
  ASSERT_EQ(actual.has_value(), expected.has_value());
  if (expected) {
    EXPECT_EQ(actual->good, expected->good);
    EXPECT_EQ(actual->reasons, expected->reasons);
  }
}

// EXPECT_TRUE and ==, for a report may be long and a difference is looked for with other tools.

void expect_line_to_keep(const Analysis& analysis, JsonOffenders offenders) {
  const std::string line = line_of(analysis, offenders);
  EXPECT_EQ(line.find('\n'), line.size() - 1) << "not one line";
  const Analysis read = read_mesh_members(line);
  EXPECT_TRUE(line_of(read, offenders) == line);
  EXPECT_TRUE(json_of(read, offenders) == json_of(analysis, offenders));
  EXPECT_TRUE(json_of(read, JsonOffenders::Omit) == json_of(analysis, JsonOffenders::Omit));
  EXPECT_TRUE(text_report(read, OffenderStyle::None) == text_report(analysis, OffenderStyle::None));
  if (offenders == JsonOffenders::List) {
    EXPECT_TRUE(text_report(read, OffenderStyle::Ids) == text_report(analysis, OffenderStyle::Ids));
  }
  expect_same_verdict(read.fitness, analysis.fitness);
}

struct NamedOptions {
  std::string name;
  AnalysisOptions options;
};

std::vector<NamedOptions> options_to_try() {
  std::vector<NamedOptions> all(6);
  all[0].name = "everything";
  all[1].name = "-a";
  all[1].options.scope = Scope::AttributesOnly;
  all[2].name = "-a, and fitness";
  all[2].options.scope = Scope::AttributesOnly;
  all[2].options.judge_fitness = true;
  all[3].name = "-g";
  all[3].options.goodness = GoodnessThresholds{2.0, 60.0, 0.1};
  all[4].name = "-b ... -f";
  all[4].options.shorter_than = 1.0;
  all[4].options.longer_than = 1.0;
  all[4].options.angle_below_degrees = 180.0;
  all[4].options.angle_above_degrees = 180.0;
  all[4].options.aspect_above = 1.5;
  all[5].name = "--exact-coincidence -f";
  all[5].options.exact_coincidence = true;
  all[5].options.aspect_above = 3.0;
  return all;
}

void expect_lines_to_keep(const std::string& name, const Soup& soup) {
  for (const auto& [options_name, options] : options_to_try()) {
    SCOPED_TRACE(name + ' ' + options_name);
    const Analysis analysis = analyze(soup, name, options);
    expect_line_to_keep(analysis, JsonOffenders::Omit);
    expect_line_to_keep(analysis, JsonOffenders::List);
  }
}

TEST(JsonRoundTrip, LineOfAMeshKeepsAllThatReportsSay) {
  test::Effort effort;
  for (const NamedSoup& each : soups_to_try()) {
    if (effort.runs_next()) {
      expect_lines_to_keep(each.name, each.soup);
    }
  }
}

TEST(JsonRoundTrip, LineOfAMeshTooLargeOrSmallForItsMeasuresKeepsAllThatReportsSay) {
  AnalysisOptions options;
  options.longer_than = 0.0;
  options.aspect_above = 1.5;
  test::Effort effort;
  for (const double scale : {1e-200, 1e155, 1e300}) {
    for (const NamedSoup& each : soups_to_try()) {
      if (!effort.runs_next()) {
        continue;
      }
      Soup soup = each.soup;
      for (Vec3& position : soup.positions) {
        position *= scale;
      }
      SCOPED_TRACE(each.name);
      expect_line_to_keep(analyze(std::move(soup), each.name, options), JsonOffenders::List);
    }
  }
}

TEST(JsonRoundTrip, LineOfARealMeshKeepsAllThatReportsSay) {
  if (!std::filesystem::is_directory(MESHALYZER_CORPUS)) {
    GTEST_SKIP() << "no corpus at " << MESHALYZER_CORPUS;
  }
  const std::uintmax_t max_bytes = 600'000 / test::one_of() / test::one_of();
  for (const std::string& file : mesh_files(MESHALYZER_CORPUS, "unreadable")) {
    if (std::filesystem::file_size(file) <= max_bytes) {
      expect_lines_to_keep(file, read_mesh(file));
    }
  }
}

}  // namespace
}  // namespace meshalyzer
