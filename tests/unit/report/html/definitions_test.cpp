#include "meshalyzer/report/html/definitions.h"

#include "meshalyzer/report/text/curvature.h"
#include "meshalyzer/report/text/defect_lines.h"
#include "meshalyzer/report/text/sections.h"
#include "meshalyzer/report/text/statistics.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

/// With every line that there may be.
Analysis analysis_with_all_lines() {
  Analysis analysis;
  analysis.format = Format::Stl;
  analysis.n_polygons = 1;
  analysis.integrity.torn_lines = 1;
  analysis.offenders.torn_lines = {3};
  analysis.characteristics.bounding_box.extend(Vec3(1, 2, 3));
  return analysis;
}

void expect_defined(const ReportRows& rows) {
  EXPECT_FALSE(rows.rows().empty());
  for (const ReportRow& row : rows.rows()) {
    EXPECT_FALSE(definition_of(row.name).empty()) << row.name;
  }
}

TEST(DefinitionOf, EachLineOfAReportIsDefined) {
  const Analysis analysis = analysis_with_all_lines();
  ReportRows rows;
  append_integrity(rows, analysis);
  append_attributes(rows, analysis.attributes);
  append_counts(rows, analysis.characteristics);
  append_extent(rows, analysis.characteristics);
  append_extent(rows, Characteristics{});
  expect_defined(rows);
}

TEST(DefinitionOf, EachToleranceIsDefined) {
  ReportRows rows;
  append_tolerances(rows, DefectReport{});
  expect_defined(rows);
}

TEST(DefinitionOf, EachQuantityIsDefined) {
  const auto expect = [](const FieldInfo& info) {
    EXPECT_FALSE(definition_of(info.label).empty()) << info.label;
  };
  for (const auto& row : kElementMeasures<Statistics>) expect(row.quantity.info);
  for (const auto& row : kCurvatures) expect(row.quantity.info);
}

TEST(DefinitionOf, EachLineOfTheCurvatureIsDefined) {
  CurvatureStatistics curvature;
  curvature.vertices.fill(1);
  ReportRows rows;
  append_curvature_counts(rows, curvature);
  expect_defined(rows);
}

TEST(DefinitionOf, UnknownWordHasNone) {
  EXPECT_EQ(definition_of("warning"), "");
  EXPECT_EQ(definition_of(""), "");
}

}  // namespace
}  // namespace meshalyzer
