#include "meshalyzer/report/json/repair_report.h"

#include "sample_repair.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace meshalyzer {
namespace {

using nlohmann::json;

json parsed(const RepairResult& result) {
  return json::parse(json_report(sample_report(result)));
}

TEST(RepairJson, HasAllKeysThatProgramsRelyOn) {
  const json report = parsed(sample_result());
  EXPECT_EQ(report["schema"], "meshfixer-report/1");
  for (const char* key : {"version", "input", "fixes", "max_deviation", "deviation", "remaining",
                          "notes", "lost", "meshes", "log"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  EXPECT_EQ(report["input"]["path"], "in.mesh");
  EXPECT_EQ(report["input"]["counts"].size(), kDefectCodes);
  EXPECT_EQ(report["meshes"][0]["path"], "out.obj");
  EXPECT_EQ(report["meshes"][0]["written"], true);
}

TEST(RepairJson, TrackingNamesWhatIsNotTheInputsFaceOfTheSameId) {
  // Faces 5 and 7 were kept, as 1 and 2 of a format that counts anew; 3 is a patch.
  EXPECT_EQ(parsed(sample_result())["meshes"][0]["tracking"],
            json::parse("[[1,5],[2,7],[3,null]]"));
}

TEST(RepairJson, TrackingLeavesOutWhatKeptItsIdUnlessItWasChanged) {
  RepairResult result = sample_result();
  LoggedOperation operation;
  operation.changed_faces = {2};
  result.log.operations = {operation};
  RepairReport repair = sample_report(result);
  repair.meshes[0].name.face_ids.named = {5, 7, 8};
  const json report = json::parse(json_report(repair));
  EXPECT_EQ(report["meshes"][0]["tracking"], json::parse("[[7,7],[8,null]]"));
}

TEST(RepairJson, LostAttributesAreCountedByKind) {
  const RepairResult result = sample_result();
  RepairReport report = sample_report(result);
  report.lost = {{AttributeKind::TextureCoordinates, 4}};
  EXPECT_EQ(json::parse(json_report(report))["lost"], json::parse(R"({"texture_coordinates": 4})"));
}

TEST(RepairJson, TrackingNamesTheFaceOfTheFile) {
  const RepairResult result = sample_result();
  RepairReport report = sample_report(result);
  const json rows = json::parse(json_report(report))["meshes"][0]["tracking"];
  // The added face, the last of the mesh, stands first in the file.
  report.meshes[0].face_records = {1, 2, 0};
  const json moved = json::parse(json_report(report))["meshes"][0]["tracking"];
  EXPECT_EQ(moved.back()[0], 1);
  EXPECT_NE(moved, rows);
}

TEST(RepairJson, TrackingOfACopyNamesTheFaceItWasMadeOf) {
  RepairResult result = sample_result();
  result.meshes[0].tracked.face_origins = {1};
  EXPECT_EQ(parsed(result)["meshes"][0]["tracking"][2], json::parse("[3,6]"));
}

TEST(RepairJson, OperationNamesInputAndOutput) {
  RepairResult result = sample_result();
  result.log.steps.resize(1);
  LoggedOperation operation;
  operation.removed_faces = {1};
  operation.added_faces = {3};
  operation.moved_vertices = {3, 4};
  operation.distance = 0.1;
  result.log.operations = {operation};
  EXPECT_EQ(parsed(result)["log"]["operations"],
            json::parse(R"([{"step": 0, "removed_faces": [6], "added_faces": [3],
                             "moved_vertices": [40, 4], "distance": 0.1}])"));
}

TEST(RepairJson, RefusalNamesTheOutputAndItsMesh) {
  RepairResult result = sample_result();
  result.log.refusals = {
      {.pass = "p", .code = DefectCode::Slit, .vertex = 3, .face = 1, .reason = "r"},
      {.pass = "p", .code = DefectCode::Slit, .vertex = 2, .face = kNoIndex, .reason = "r"}};
  EXPECT_EQ(parsed(result)["log"]["refused"],
            json::parse(R"([{"pass": "p", "code": "slit", "mesh": 0, "vertex": 3, "face": null,
                             "reason": "r"},
                            {"pass": "p", "code": "slit", "mesh": null, "vertex": null,
                             "face": null, "reason": "r"}])"));
}

TEST(RepairJson, DefectHasElementsByIdAndNullForWhatIsNotMeasured) {
  const RepairResult result = sample_result();
  RepairReport report = sample_report(result);
  Defect defect;
  defect.faces = {0, 1};
  defect.edges = {{1, 2}};
  defect.pairs = {{0, 1, ContactKind::Touching}};
  defect.positions = {{0.1, 0, 0}};
  defect.limit = std::numeric_limits<double>::infinity();
  defect.fixable = false;
  add_defect(report.meshes[0].remaining, DefectCode::SelfIntersection, defect);
  const json mesh = json::parse(json_report(report))["meshes"][0];
  EXPECT_EQ(mesh["total"], 1);
  EXPECT_EQ(mesh["defects"][0], json::parse(R"({"code": "self-intersection", "severity": "error",
      "vertices": [], "edges": [[2, 3]], "faces": [1, 2], "pairs": [[1, 2, "touching"]],
      "positions": [[0.1, 0, 0]], "value": null, "limit": null, "fixable": false})"));
}

TEST(RepairJson, RemainingCountsOnlyWhatWasAskedFor) {
  const RepairResult result = sample_result();
  RepairReport report = sample_report(result);
  add_defect(report.meshes[0].remaining, DefectCode::Disjoint);
  add_defect(report.meshes[0].remaining, DefectCode::Hole);
  EXPECT_EQ(json::parse(json_report(report))["remaining"], 1);
}

TEST(RepairJson, CutListIsSaidToBeCut) {
  RepairResult result = sample_result();
  add_defect(result.before, DefectCode::Hole);
  result.before.counts[static_cast<std::size_t>(DefectCode::Hole)] = 5;
  const json input = parsed(result)["input"];
  EXPECT_EQ(input["counts"]["hole"], 5);
  EXPECT_EQ(input["total"], 5);
  EXPECT_EQ(input["listed"], 1);
}

TEST(RepairJson, PathOfAnyBytesCanBeRead) {
  const RepairResult result = sample_result();
  RepairReport report = sample_report(result);
  report.input.path = "\xFF.mesh";
  const json input = json::parse(json_report(report))["input"];
  EXPECT_EQ(input["path"], "\xEF\xBF\xBD.mesh");
  EXPECT_EQ(input["path_bytes"], "\xC3\xBF.mesh");
}

TEST(RepairJson, PatchesTellWhatBecameOfThem) {
  RepairResult result = sample_result();
  add_patch(result);
  PatchOutcome& left = add_patch(result);
  left.is_mended = false;
  left.reason = "it is so";
  EXPECT_EQ(parsed(result)["patches"], json::parse(R"([
    {"face": 5, "faces": 2, "mended": true, "passes": ["split edges", "cut intersections"],
     "distance": 0.25},
    {"face": 5, "faces": 2, "mended": false, "passes": ["split edges", "cut intersections"],
     "distance": 0.25, "reason": "it is so"}])"));
  EXPECT_FALSE(parsed(sample_result()).contains("patches"));
}

TEST(DefectsJson, TellsWhatCountsAndHowManyOfIt) {
  DefectReport report;
  add_defect(report, DefectCode::Disjoint);
  add_defect(report, DefectCode::Hole);
  report.warnings = {"w"};
  const json all = json::parse(json_report(FoundDefects{MeshName(), report, DefectCodes::all()}));
  EXPECT_EQ(all["remaining"], 2);
  EXPECT_EQ(all["fixes"].size(), kDefectCodes);
  const json some = json::parse(json_report(FoundDefects{MeshName(), report, {DefectCode::Hole}}));
  EXPECT_EQ(some["remaining"], 1);
  EXPECT_EQ(some["fixes"], json::parse(R"(["hole"])"));
  EXPECT_EQ(some["input"]["total"], 2);
  EXPECT_EQ(some["input"]["warnings"], json::parse(R"(["w"])"));
  EXPECT_FALSE(some.contains("meshes"));
}

}  // namespace
}  // namespace meshalyzer
