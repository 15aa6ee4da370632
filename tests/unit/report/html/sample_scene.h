#pragma once

#include "meshalyzer/report/html/page_mesh.h"

#include <limits>
#include <string>
#include <utility>

namespace meshalyzer {

/// A made-up scene of two triangles, the first of which is lit up for the defect 0.
inline Scene sample_scene() {
  Scene scene;
  scene.centre = {10.0, 20.0, 30.5};
  scene.radius = 2.5;
  scene.detail = {
      .positions = {0.0F, 0.5F, -1.25F, 1.0F, 2.0F, 3.0F, -1.0F, 4.0F, 5.0F, 0.1F, 0.2F, 0.3F},
      .normals = {0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F},
      .triangles = {0, 1, 2, 1, 0, 3},
      .vertices = {0, 1, 2, 3},
      .faces = {0, 1}};
  scene.fields = {{.name = FieldName::Mean,
                   .place = FieldPlace::Vertices,
                   .kind = FieldKind::Signed,
                   .detail = {-1.5F, std::numeric_limits<float>::quiet_NaN(), 0.0F, 2.0F},
                   .context = {},
                   .scale = {Palette::Diverging, -1.0, 1.0},
                   .min = -1.5,
                   .max = 2.0}};
  scene.highlights = {{.number = 0,
                       .faces = {1},
                       .segments = {0.0F, 0.0F, 0.0F, 1.0F, 1.0F, 1.0F},
                       .points = {0.5F, 0.5F, 0.5F},
                       .focus = {0.25F, 0.5F, 0.75F},
                       .radius = 0.5F,
                       .is_cut = true}};
  scene.lines.borders = {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F};
  scene.n_faces = 2;
  return scene;
}

/// Returns the name of the mesh of the scene, with vertices 10, 20, 30, 40 and faces 7, 9.
inline MeshName sample_name(std::string path = "folder/sample.mesh") {
  return {.path = std::move(path),
          .format = Format::Mesh,
          .vertex_ids = {.first = 1, .named = {10, 20, 30, 40}},
          .face_ids = {.first = 1, .named = {7, 9}},
          .n_vertices = 4,
          .n_faces = 2};
}

/// A hole round the vertices 10 and 20, and three duplicates that are counted but not listed.
inline DefectReport sample_defects() {
  DefectReport report;
  Defect hole;
  hole.code = DefectCode::Hole;
  hole.edges = {{0, 1}};
  report.defects.push_back(hole);
  report.counts[static_cast<std::size_t>(DefectCode::Hole)] = 1;
  report.counts[static_cast<std::size_t>(DefectCode::DuplicateFacet)] = 3;
  return report;
}

}  // namespace meshalyzer
