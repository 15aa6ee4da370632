#include "meshalyzer/report/text/defects_report.h"

#include "has_line.h"
#include "sample_repair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

using test::HasLine;
using testing::HasSubstr;
using testing::Not;

std::string report_of(const DefectReport& report, const DefectCodes& requested = default_fixes()) {
  const MeshName mesh{.path = "a.off",
                      .format = Format::Off,
                      .vertex_ids = {},
                      .face_ids = {},
                      .n_vertices = 9,
                      .n_faces = 8};
  return text_report(FoundDefects{mesh, report, requested}, ListLength::Short);
}

TEST(DefectsReport, SoundMeshHasZeroOfEachCodeAndNoPlaces) {
  const std::string text = report_of({});
  for (const DefectCode code : all_defect_codes()) {
    EXPECT_THAT(text, HasLine(std::string(defect_name(code)) + ": 0"));
  }
  EXPECT_THAT(text, HasLine("defects: 0"));
  EXPECT_THAT(text, HasLine("asked for: 0"));
  EXPECT_THAT(text, Not(HasSubstr("WHERE")));
}

TEST(DefectsReport, FileAndTolerancesAreTold) {
  DefectReport report;
  report.tolerances = {.degeneracy = 0.125, .slit = 0.25, .height = 0.5, .max_foldover_angle = 2};
  report.warnings = {"something contradicts"};
  const std::string text = report_of(report);
  EXPECT_THAT(text, HasLine("file: a.off"));
  EXPECT_THAT(text, HasLine("format: off"));
  EXPECT_THAT(text, HasLine("vertices: 9"));
  EXPECT_THAT(text, HasLine("faces: 8"));
  EXPECT_THAT(text, HasLine("degeneracy tolerance: 0.125"));
  EXPECT_THAT(text, HasLine("slit tolerance: 0.25"));
  EXPECT_THAT(text, HasLine("height tolerance: 0.5"));
  EXPECT_THAT(text, HasLine("maximum foldover angle: 2"));
  EXPECT_THAT(text, HasLine("warning: something contradicts"));
}

TEST(DefectsReport, WhatDoesNotCountIsListedAllTheSame) {
  DefectReport report;
  add_defect(report, DefectCode::Disjoint, defect_of_faces({3}));
  add_defect(report, DefectCode::Hole, defect_of_vertices({1}));
  const std::string text = report_of(report);
  EXPECT_THAT(text, HasLine("disjoint: 1 (not asked for)"));
  EXPECT_THAT(text, HasLine("hole: 1"));
  EXPECT_THAT(text, HasLine("defects: 2"));
  EXPECT_THAT(text, HasLine("asked for: 1"));
  EXPECT_THAT(text, HasLine("fix of hole: fill holes, drop fragments"));
  EXPECT_THAT(text, Not(HasSubstr("fix of slit")));
  EXPECT_THAT(text, HasLine("disjoint: component of face 4"));
  EXPECT_THAT(report_of(report, DefectCodes::all()), HasLine("asked for: 2"));
}

TEST(DefectsReport, WhatARepairWouldDoComesLast) {
  RepairResult result = sample_result();
  add_patch(result);
  const RepairReport names = sample_report(result);
  const DefectCodes requested = default_fixes();
  EXPECT_THAT(text_report(FoundDefects{names.input, result.before, requested, result.patches},
                          ListLength::Short),
              testing::EndsWith("WHAT A REPAIR WOULD MAKE OF SELF-INTERSECTIONS\n"
                                "patch of face 5: 2 faces; mended by split edges, cut "
                                "intersections; moved by at most 0.25\n"));
}

}  // namespace
}  // namespace meshalyzer
