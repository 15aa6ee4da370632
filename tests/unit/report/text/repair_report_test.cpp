#include "meshalyzer/report/text/repair_report.h"

#include "has_line.h"
#include "sample_repair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

using test::HasLine;
using testing::HasSubstr;
using testing::Not;

std::string report_of(const RepairResult& result, ListLength lists = ListLength::Short) {
  return text_report(sample_report(result), lists);
}

RepairResult result_with_a_step() {
  RepairResult result = sample_result();
  LogStep step;
  step.pass = "weld borders";
  step.operations = 2;
  step.undone = 1;
  step.faces_changed = 1;
  step.vertices_removed = 2;
  step.distance = 0.125;
  result.log.steps = {step};
  LoggedOperation merge;
  merge.changed_faces = {2};
  merge.removed_vertices = {2};
  merge.distance = 0.125;
  LoggedOperation other;
  other.added_faces = {3};
  other.added_vertices = {4};
  result.log.operations = {merge, other};
  return result;
}

TEST(RepairReport, SizesBeforeAndAfterAndDeviationsAreTold) {
  const std::string text = report_of(sample_result());
  EXPECT_THAT(text, HasLine("file: in.mesh"));
  EXPECT_THAT(text, HasLine("written: out.obj"));
  EXPECT_THAT(text, HasLine("vertices: 4 -> 4"));
  EXPECT_THAT(text, HasLine("faces: 3 -> 3"));
  EXPECT_THAT(text, HasLine("maximum deviation: 0.5"));
  EXPECT_THAT(text, HasLine("largest deviation: 0.25"));
}

TEST(RepairReport, NothingToDoIsSaid) {
  const std::string text = report_of(sample_result());
  EXPECT_THAT(text, HasLine("changes: none"));
  EXPECT_THAT(text, Not(HasSubstr("WHAT REMAINS")));
}

TEST(RepairReport, MeshThatWasNotWrittenIsSaidToBeNone) {
  const RepairResult result = sample_result();
  RepairReport report = sample_report(result);
  report.meshes[0].name.path.clear();
  report.notes = {"something to know"};
  const std::string text = text_report(report, ListLength::Short);
  EXPECT_THAT(text, HasLine("written: nothing"));
  EXPECT_THAT(text, HasLine("note: something to know"));
}

TEST(RepairReport, LostAttributesStandOnOneLine) {
  const RepairResult result = sample_result();
  RepairReport report = sample_report(result);
  report.lost = {{AttributeKind::TextureCoordinates, 33963}, {AttributeKind::Materials, 1}};
  EXPECT_THAT(text_report(report, ListLength::Short),
              HasLine("lost: 33963 texture coordinates, 1 material"));
}

TEST(RepairReport, CountsOfEachCodeStandBeforeAndAfter) {
  RepairResult result = sample_result();
  add_defect(result.before, DefectCode::Hole);
  add_defect(result.before, DefectCode::Hole);
  RepairReport report = sample_report(result);
  add_defect(report.meshes[0].remaining, DefectCode::Disjoint);
  add_defect(report.meshes[0].remaining, DefectCode::Hole);
  const std::string text = text_report(report, ListLength::Short);
  EXPECT_THAT(text, HasLine("hole: 2 -> 1"));
  EXPECT_THAT(text, HasLine("disjoint: 0 -> 1 (not asked for)"));
  EXPECT_THAT(text, HasLine("defects: 2 -> 2"));
  EXPECT_THAT(text, HasLine("asked for and left: 1"));
}

TEST(RepairReport, StepCountsWhatItChanged) {
  EXPECT_THAT(report_of(result_with_a_step()),
              HasLine("weld borders: 2 changes, 1 face changed, 2 vertices removed, "
                      "largest move 0.125, 1 change undone"));
}

TEST(RepairReport, StepThatOnlyNumbersSaysSo) {
  RepairResult result = sample_result();
  result.log.steps.resize(1);
  result.log.steps[0].pass = "renumber";
  result.log.steps[0].operations = 1;
  EXPECT_THAT(report_of(result), HasLine("renumber: 1 change of ids or normals"));
}

TEST(RepairReport, EachChangeIsNamedWhereAllIsAskedFor) {
  const std::string text = report_of(result_with_a_step(), ListLength::Full);
  EXPECT_THAT(text, HasLine("change: weld borders, changed faces 7, removed vertices 30, "
                            "largest move 0.125"));
  EXPECT_THAT(text, HasLine("change: weld borders, added faces 3, added vertices 4"));
  EXPECT_THAT(report_of(result_with_a_step()), Not(HasSubstr("change: ")));
}

TEST(RepairReport, PlacesLeftForOneReasonAreOneLine) {
  RepairResult result = sample_result();
  const LoggedRefusal left{.pass = "fill holes",
                           .code = DefectCode::Hole,
                           .vertex = 0,
                           .face = kNoIndex,
                           .reason = "it is too large"};
  LoggedRefusal other = left;
  other.vertex = 4;
  result.log.refusals = {left, other, left};
  EXPECT_THAT(report_of(result),
              HasLine("left by fill holes: hole, 2 places: it is too large; vertices 1 4"));
}

TEST(RepairReport, WhatRemainsAndWasNotAskedForIsListedOnlyInFull) {
  const RepairResult result = sample_result();
  RepairReport report = sample_report(result);
  add_defect(report.meshes[0].remaining, DefectCode::Disjoint, defect_of_faces({2}));
  EXPECT_THAT(text_report(report, ListLength::Short), Not(HasSubstr("WHAT REMAINS")));
  EXPECT_THAT(text_report(report, ListLength::Full), HasLine("disjoint: component of face 3"));
}

TEST(RepairReport, OfSeveralMeshesOnlyThoseWithSomethingLeftAreNamed) {
  RepairResult result = sample_result();
  result.meshes.push_back(result.meshes[0]);
  RepairReport report = sample_report(result);
  report.meshes.push_back(report.meshes[0]);
  report.meshes[1].name.path = "other.obj";
  add_defect(report.meshes[1].remaining, DefectCode::Hole, defect_of_vertices({1}));
  const std::string text = text_report(report, ListLength::Short);
  EXPECT_THAT(text, HasLine("written: out.obj"));
  EXPECT_THAT(text, HasLine("written: other.obj"));
  EXPECT_THAT(text, HasLine("vertices: 4 -> 8"));
  EXPECT_THAT(text, HasSubstr("WHAT REMAINS, AND WHY\nmesh: other.obj\nhole: vertex 2\n"));
  EXPECT_THAT(text, Not(HasLine("mesh: out.obj")));
}

TEST(RepairReport, PatchesAreNamedByTheirFirstFaces) {
  RepairResult result = sample_result();
  add_patch(result);
  PatchOutcome& left = add_patch(result);
  left.is_mended = false;
  left.reason = "it is so";
  PatchOutcome& untouched = add_patch(result);
  untouched = {.defect = untouched.defect,
               .passes = {},
               .distance = 0.0,
               .is_mended = false,
               .reason = "so it is"};
  const std::string text = text_report(sample_report(result), ListLength::Short);
  EXPECT_THAT(text, HasLine("patch of face 5: 2 faces; mended by split edges, cut intersections; "
                            "moved by at most 0.25"));
  EXPECT_THAT(text, HasLine("patch of face 5: 2 faces; changed by split edges, cut intersections; "
                            "moved by at most 0.25; still intersects: it is so"));
  EXPECT_THAT(text, HasLine("patch of face 5: 2 faces; left; still intersects: so it is"));
}

TEST(RepairReport, OfManyPatchesTheFirstAreToldAndTheRestCounted) {
  RepairResult result = sample_result();
  for (int i = 0; i < 14; ++i) add_patch(result);
  EXPECT_THAT(text_report(sample_report(result), ListLength::Short),
              HasLine("not listed: 2 patches"));
  EXPECT_THAT(text_report(sample_report(result), ListLength::Full), Not(HasSubstr("not listed")));
}

}  // namespace
}  // namespace meshalyzer
