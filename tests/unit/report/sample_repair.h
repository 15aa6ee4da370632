#pragma once

#include "meshalyzer/report/repair_story.h"

namespace meshalyzer {

/// A made-up repair: of the vertices 10, 20, 30, 40 the third is gone, and one was added; of the
/// faces 5, 6, 7 the second is gone, and a patch of one face was added.
inline RepairResult sample_result() {
  RepairResult result;
  result.max_deviation = 0.5;
  result.deviation = 0.25;
  result.meshes.resize(1);
  Draft& draft = result.meshes[0].draft;
  draft.n_input_vertices = 4;
  draft.n_input_faces = 3;
  draft.vertex_keys = {0, 1, 3, 4};
  draft.face_keys = {0, 2, 3};
  draft.vertex_origins = {kNoIndex};
  draft.face_origins = {kNoIndex};
  return result;
}

/// It was read from a file that names its ids, and written to one that counts from 1.
///
/// @param result  As sample_result(); the story refers to it.
inline RepairStory sample_story(const RepairResult& result) {
  RepairStory story{.input = {.path = "in.mesh",
                              .format = Format::Mesh,
                              .vertex_ids = {.first = 1, .named = {10, 20, 30, 40}},
                              .face_ids = {.first = 1, .named = {5, 6, 7}},
                              .n_vertices = 4,
                              .n_faces = 3},
                    .result = result,
                    .fixes = default_fixes(),
                    .meshes = {},
                    .notes = {}};
  FinalMesh& mesh = story.meshes.emplace_back();
  mesh.name = {.path = "out.obj",
               .format = Format::Obj,
               .vertex_ids = {},
               .face_ids = {},
               .n_vertices = 4,
               .n_faces = 3};
  return story;
}

/// Adds a defect to a report, which counts it too.
inline Defect& add_defect(DefectReport& report, DefectCode code) {
  ++report.counts[static_cast<std::size_t>(code)];
  Defect& defect = report.defects.emplace_back();
  defect.code = code;
  return defect;
}

}  // namespace meshalyzer
