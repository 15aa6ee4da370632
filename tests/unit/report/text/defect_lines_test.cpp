#include "meshalyzer/report/text/defect_lines.h"

#include "has_line.h"
#include "sample_repair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

namespace meshalyzer {
namespace {

using test::HasLine;
using testing::HasSubstr;
using testing::Not;

/// Ids that are ten times the index.
MeshName tens() {
  MeshName mesh;
  for (std::int32_t i = 0; i < 100; ++i) mesh.vertex_ids.named.push_back(10 * i);
  mesh.face_ids.first = 0;
  return mesh;
}

std::string lines_of(const DefectReport& report, ListLength lists = ListLength::Short,
                     const DefectCodes& codes = DefectCodes::all()) {
  const MeshName mesh = tens();
  TextLines lines;
  append_defects(lines, {mesh, report, codes}, lists);
  return lines.text();
}

TEST(AppendDefects, SoundMeshHasNoLine) {
  EXPECT_EQ(lines_of({}), "");
}

TEST(AppendDefects, ElementsAreNamedByTheIdsOfTheFile) {
  DefectReport report;
  Defect defect;
  defect.edges = {{1, 2}};
  defect.faces = {3, 4, 5};
  defect.positions = {{0.5, -0.0, 2}};
  defect.value = 3.0;
  add_defect(report, DefectCode::NonManifold, defect);
  EXPECT_THAT(lines_of(report),
              HasLine("non-manifold: edge 10-20, faces 3 4 5; at 0.5 0 2; 3 faces at it"));
}

TEST(AppendDefects, WhatWasMeasuredIsNamedWithItsLimit) {
  DefectReport report;
  Defect flat;
  flat.faces = {7};
  flat.value = 0.25;
  flat.limit = 0.5;
  add_defect(report, DefectCode::FlatFacet, flat);
  Defect numbering;
  numbering.vertices = {4};
  numbering.value = 40.0;
  numbering.limit = 5.0;
  add_defect(report, DefectCode::Numbering, numbering);
  EXPECT_THAT(lines_of(report), HasLine("flat-facet: face 7; altitude 0.25, limit 0.5"));
  EXPECT_THAT(lines_of(report), HasLine("numbering: vertex 40; id 40, expected 5"));
}

TEST(AppendDefects, ComponentIsNamedByItsFirstFace) {
  DefectReport report;
  Defect defect;
  defect.faces = {8};
  defect.value = 1.0;
  add_defect(report, DefectCode::Disjoint, defect);
  EXPECT_THAT(lines_of(report), HasLine("disjoint: component of face 8; 1 face"));
}

TEST(AppendDefects, PairsAreToldWithTheirKind) {
  DefectReport report;
  Defect defect;
  defect.pairs = {{1, 2, ContactKind::Crossing}, {1, 3, ContactKind::Touching}};
  defect.value = 2.0;
  defect.fixable = false;
  add_defect(report, DefectCode::SelfIntersection, defect);
  EXPECT_THAT(lines_of(report),
              HasLine("self-intersection: pairs 1/2 crossing 1/3 touching; 2 pairs; no fix yet"));
}

TEST(AppendDefects, WhatNoListHoldsIsToldInWords) {
  DefectReport report;
  Defect defect;
  defect.faces = {3};
  defect.detail = "there is no vertex 8";
  add_defect(report, DefectCode::Corrupt, defect);
  EXPECT_THAT(lines_of(report), HasLine("corrupt: face 3; there is no vertex 8"));
}

TEST(AppendDefects, ListOfElementsIsCutUnlessAllIsAskedFor) {
  DefectReport report;
  Defect defect;
  defect.faces.resize(14);
  std::iota(defect.faces.begin(), defect.faces.end(), 0);
  add_defect(report, DefectCode::Corrupt, defect);
  EXPECT_THAT(lines_of(report), HasLine("corrupt: faces 0 1 2 3 4 5 6 7 8 9 10 11 and 2 more"));
  EXPECT_THAT(lines_of(report, ListLength::Full),
              HasLine("corrupt: faces 0 1 2 3 4 5 6 7 8 9 10 11 12 13"));
}

TEST(AppendDefects, LinesOfEachCodeAreCutUnlessAllAreAskedFor) {
  DefectReport report;
  for (Index v = 0; v < 14; ++v) add_defect(report, DefectCode::Hole, defect_of_vertices({v}));
  add_defect(report, DefectCode::OrphanVertex, defect_of_vertices({20}));
  const std::string text = lines_of(report);
  EXPECT_THAT(text, HasLine("hole: vertex 110"));
  EXPECT_THAT(text, Not(HasSubstr("hole: vertex 120")));
  EXPECT_THAT(text, HasLine("not listed: 2 hole"));
  EXPECT_THAT(text, HasLine("orphan-vertex: vertex 200"));
  const std::string full = lines_of(report, ListLength::Full);
  EXPECT_THAT(full, HasLine("hole: vertex 130"));
  EXPECT_THAT(full, Not(HasSubstr("not listed")));
}

TEST(AppendDefects, WhatTheReportDoesNotListIsCounted) {
  DefectReport report;
  add_defect(report, DefectCode::Hole, defect_of_vertices({1}));
  report.counts[static_cast<std::size_t>(DefectCode::Hole)] = 4;
  report.counts[static_cast<std::size_t>(DefectCode::Flipped)] = 1;
  const std::string text = lines_of(report, ListLength::Full);
  EXPECT_THAT(text, HasLine("not listed: 3 hole"));
  EXPECT_THAT(text, HasLine("not listed: 1 flipped"));
}

TEST(AppendDefects, OtherCodesThanThoseAskedForAreLeftOut) {
  DefectReport report;
  add_defect(report, DefectCode::Disjoint, defect_of_faces({1}));
  add_defect(report, DefectCode::Hole, defect_of_vertices({1}));
  EXPECT_EQ(lines_of(report, ListLength::Short, {DefectCode::Hole}), "hole: vertex 10\n");
}

}  // namespace
}  // namespace meshalyzer
