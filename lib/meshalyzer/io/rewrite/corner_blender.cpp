#include "meshalyzer/io/rewrite/corner_blender.h"

#include <utility>

namespace meshalyzer {
namespace {

/// Returns the corner of a triangle that names a vertex.
std::optional<Index> corner_at(const Soup& source, Index triangle, Index vertex) {
  const Triangle& t = source.triangles[triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    if (t[k] == vertex) {
      return corner_number({triangle, k});
    }
  }
  return std::nullopt;
}

}  // namespace

CornerBlender::CornerBlender(const EditedMesh& mesh, const FaceRecords& records,
                             HasSameAttributes has_same_attributes)
    : mesh_(mesh), records_(records), has_same_attributes_(std::move(has_same_attributes)) {}

Blend CornerBlender::blend(FanCorner corner) {
  const Index model = model_of(mesh_.faces[corner.triangle]);
  if (model == kNoIndex) {
    return {};
  }
  const Index v = mesh_.soup.triangles[corner.triangle][corner.corner];
  const Index vertex = mesh_.vertices[v].record;
  if (const std::optional<Index> found = corner_in_record(model, vertex)) {
    return single_blend(*found);
  }
  const Triangle& corners = mesh_.source.triangles[model];
  if (!has_all_corners(corners)) {
    return {};
  }
  if (const std::optional<Index> found = corner_beside(model, vertex)) {
    return single_blend(*found);
  }
  return blend_at(
      mesh_.soup.positions[v], corners_of(mesh_.source, model),
      {corner_number({model, 0}), corner_number({model, 1}), corner_number({model, 2})});
}

std::optional<Index> CornerBlender::corner_in_record(Index model, Index vertex) const {
  if (vertex == kNoIndex) {
    return std::nullopt;
  }
  const Index record = records_.record_of(model);
  std::optional<Index> found = corner_at(mesh_.source, model, vertex);
  for (Index t = records_.first_triangle[record]; !found && t < records_.first_triangle[record + 1];
       ++t) {
    found = corner_at(mesh_.source, t, vertex);
  }
  return found;
}

std::optional<Index> CornerBlender::corner_beside(Index model, Index vertex) {
  if (vertex == kNoIndex) {
    return std::nullopt;
  }
  if (!faces_) {
    faces_ = std::make_unique<VertexFaces>(mesh_.source);
  }
  std::optional<Index> found;
  for_each_face_beside(mesh_.source, *faces_, mesh_.source.triangles[model], vertex,
                       [&](Index face) {
                         if (!found && !has_seam_between(face, model)) {
                           found = corner_at(mesh_.source, face, vertex);
                         }
                       });
  return found;
}

bool CornerBlender::has_seam_between(Index a, Index b) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::optional<Index> other = corner_at(mesh_.source, b, mesh_.source.triangles[a][k]);
    if (other && !has_same_attributes_(corner_number({a, k}), *other)) {
      return true;
    }
  }
  return false;
}

}  // namespace meshalyzer
