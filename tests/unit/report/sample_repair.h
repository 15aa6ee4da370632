#pragma once

#include "meshalyzer/report/repair_report.h"

#include <utility>
#include <vector>

namespace meshalyzer {

/// A made-up repair: of the vertices 10, 20, 30, 40 the third is gone, and one was added; of the
/// faces 5, 6, 7 the second is gone, and a patch of one face was added.
inline RepairResult sample_result() {
  RepairResult result;
  result.max_deviation = 0.5;
  result.deviation = 0.25;
  result.meshes.resize(1);
  TrackedMesh& tracked = result.meshes[0].tracked;
  tracked.n_input_vertices = 4;
  tracked.n_input_faces = 3;
  tracked.vertex_keys = {0, 1, 3, 4};
  tracked.face_keys = {0, 2, 3};
  tracked.vertex_origins = {kNoIndex};
  tracked.face_origins = {kNoIndex};
  return result;
}

/// It was read from a file that names its ids, and written to one that counts from 1.
///
/// @param result  As sample_result(); the report refers to it.
inline RepairReport sample_report(const RepairResult& result) {
  RepairReport report{.input = {.path = "in.mesh",
                                .format = Format::Mesh,
                                .vertex_ids = {.first = 1, .named = {10, 20, 30, 40}},
                                .face_ids = {.first = 1, .named = {5, 6, 7}},
                                .n_vertices = 4,
                                .n_faces = 3},
                      .result = result,
                      .fixes = default_fixes(),
                      .meshes = {},
                      .notes = {}};
  FinalMesh& mesh = report.meshes.emplace_back();
  mesh.name = {.path = "out.obj",
               .format = Format::Obj,
               .vertex_ids = {},
               .face_ids = {},
               .n_vertices = 4,
               .n_faces = 3};
  return report;
}

/// Adds a defect to a report, which counts it too.
inline void add_defect(DefectReport& report, DefectCode code, Defect defect = {}) {
  ++report.counts[static_cast<std::size_t>(code)];
  defect.code = code;
  report.defects.push_back(defect);
}

inline Defect defect_of_faces(std::vector<Index> faces) {
  Defect defect;
  defect.faces = std::move(faces);
  return defect;
}

inline Defect defect_of_vertices(std::vector<Index> vertices) {
  Defect defect;
  defect.vertices = std::move(vertices);
  return defect;
}

/// Adds a self-intersection, and what became of it: of the faces of the sample, the first two.
inline PatchOutcome& add_patch(RepairResult& result) {
  PatchOutcome& patch = result.patches.emplace_back();
  patch.defect = result.before.defects.size();
  patch.passes = {"split edges", "cut intersections"};
  patch.distance = 0.25;
  patch.is_mended = true;
  add_defect(result.before, DefectCode::SelfIntersection, defect_of_faces({0, 1}));
  return patch;
}

}  // namespace meshalyzer
