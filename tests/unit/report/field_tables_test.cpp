#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/analysis/fields.h"
#include "meshalyzer/report/figures.h"
#include "meshalyzer/report/html/definitions.h"
#include "meshalyzer/report/html/statistics_section.h"
#include "meshalyzer/report/json/mesh.h"
#include "meshalyzer/report/json/report.h"
#include "meshalyzer/report/json/schema.h"
#include "meshalyzer/report/text/mesh_report.h"
#include "meshalyzer/report/text/sections.h"
#include "meshalyzer/report/text/set_report.h"
#include "meshalyzer/set/set_counts.h"
#include "support/shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace meshalyzer {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// With a value of every quantity, and two components.
const Analysis& full_analysis() {
  static const Analysis analysis = [] {
    AnalysisOptions options;
    options.curvature = VertexArea::Mixed;
    return analyze(shapes::merged(shapes::cube(), shapes::cube(1.0, Vec3(5, 0, 0))), "two.mesh",
                   options);
  }();
  return analysis;
}

SetAnalysis full_set() {
  SetAnalysis set;
  set.statistics.emplace(full_analysis().characteristics);
  return set;
}

json report_of(const Analysis& analysis) {
  return json::parse(json_report({&analysis, 1}, nullptr, JsonOffenders::Omit))["meshes"][0];
}

json properties_of(const std::string& definition) {
  return json::parse(json_schema())["$defs"][definition]["properties"];
}

/// Expects a row in what is written of an object, in what the schema says of it, and, by its label,
/// in what pages explain.
void expect_row(const FieldInfo& info, const json& object, const std::string& definition) {
  const std::string key(info.key);
  SCOPED_TRACE(key);
  EXPECT_TRUE(object.contains(key));
  EXPECT_TRUE(properties_of(definition).contains(key));
  if (!info.label.empty()) {
    EXPECT_EQ(definition_of(info.label), info.definition);
  }
}

/// Expects the reader to need a row's member.
void expect_read(const FieldInfo& info, const std::string& object) {
  json mesh = report_of(full_analysis());
  ASSERT_NO_THROW(static_cast<void>(read_mesh_members(mesh.dump())));
  mesh[object].erase(std::string(info.key));
  EXPECT_ANY_THROW(static_cast<void>(read_mesh_members(mesh.dump()))) << info.key;
}

TEST(FieldTables, EachFieldOfAMeshIsInAllReports) {
  const json mesh = report_of(full_analysis());
  const std::string text = text_report(full_analysis(), OffenderStyle::None);
  const auto expect = [&](const std::string& object) {
    return [&, object](const auto& row) {
      expect_row(row.info, mesh[object], object);
      expect_read(row.info, object);
      const bool is_told = row.info.key != "torn_lines";  // of which there are none here
      if (!row.info.label.empty() && is_told) {
        EXPECT_THAT(text, HasSubstr('\n' + std::string(row.info.label)));
      }
    };
  };
  for_each_row(kIntegrityFields, expect("integrity"));
  for_each_row(kAttributeFields, expect("attributes"));
  for_each_row(kCharacteristicFields, expect("characteristics"));
}

TEST(FieldTables, EachFieldOfAComponentIsInJsonAndSchema) {
  const json component = report_of(full_analysis())["per_component"][1];
  for_each_row(kComponentFields,
               [&](const auto& row) { expect_row(row.info, component, "component"); });
  for (const auto& row : kElementMeasures<Summary>) {
    expect_row(row.quantity.info, component, "component");
  }
}

TEST(FieldTables, EachStatisticIsInAllReports) {
  const json mesh = report_of(full_analysis())["characteristics"];
  const json set = json::parse([] {
    const SetAnalysis analysis = full_set();
    return json_report({}, &analysis, JsonOffenders::Omit);
  }())["set"];
  const std::string text = text_report(full_analysis(), OffenderStyle::None);
  const std::string text_of_set = text_report(full_set(), OffenderStyle::None);
  HtmlWriter page;
  append_statistics_section(page, full_analysis().characteristics);
  const std::string& html = page.html();
  for (const auto& row : kElementMeasures<Statistics>) {
    const std::string label(row.quantity.info.label);
    expect_row(row.quantity.info, mesh, "characteristics");
    expect_row(row.quantity.info, set, "set");
    expect_read(row.quantity.info, "characteristics");
    EXPECT_THAT(text, HasSubstr('\n' + label + " count"));
    EXPECT_THAT(text_of_set, HasSubstr('\n' + label + " count"));
    EXPECT_THAT(html, HasSubstr('>' + label + '<'));
  }
}

TEST(FieldTables, EachCurvatureIsInAllReports) {
  const json mesh = report_of(full_analysis())["characteristics"];
  const std::string text = text_report(full_analysis(), OffenderStyle::None);
  for (const auto& row : kCurvatures) {
    expect_row(row.quantity.info, mesh, "characteristics");
    expect_read(row.quantity.info, "characteristics");
    EXPECT_THAT(text, HasSubstr('\n' + std::string(row.quantity.info.label) + " count"));
  }
}

TEST(FieldTables, EachFigureIsInJsonAndSchema) {
  const json statistics = report_of(full_analysis())["characteristics"]["edge_length"];
  for (const auto& row : kFigures) {
    for (const char* const definition : {"statistics", "summary"}) {
      EXPECT_TRUE(properties_of(definition).contains(std::string(row.info.key))) << row.info.key;
    }
    EXPECT_TRUE(statistics[std::string(row.info.key)].is_number()) << row.info.key;
  }
}

TEST(FieldTables, EachCountOfASetIsInAllReports) {
  const SetAnalysis analysis = full_set();
  const json set = json::parse(json_report({}, &analysis, JsonOffenders::Omit))["set"];
  const std::string text = text_report(analysis, OffenderStyle::None);
  for (const SetCount& count : kSetCounts) {
    EXPECT_TRUE(set.contains(std::string(count.info.key))) << count.info.key;
    EXPECT_TRUE(properties_of("set").contains(std::string(count.info.key))) << count.info.key;
    EXPECT_THAT(text, HasSubstr("\ntotal " + std::string(count.info.label) + ": "));
  }
}

TEST(FieldTables, WithAttributesAloneWhatIsMeasuredIsNull) {
  AnalysisOptions options;
  options.scope = Scope::AttributesOnly;
  const Analysis analysis = analyze(shapes::cube(), "cube.mesh", options);
  const json mesh = report_of(analysis)["characteristics"];
  for_each_row(kCharacteristicFields, [&](const auto& row) {
    if (row.known == Known::Measured) {
      EXPECT_TRUE(mesh[std::string(row.info.key)].is_null()) << row.info.key;
    }
  });
  for (const auto& row : kElementMeasures<Statistics>) {
    EXPECT_TRUE(mesh[std::string(row.quantity.info.key)].is_null()) << row.quantity.info.key;
  }
}

}  // namespace
}  // namespace meshalyzer
