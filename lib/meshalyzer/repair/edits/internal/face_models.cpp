#include "meshalyzer/repair/edits/internal/face_models.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/repair/edits/internal/turned_face.h"

#include <algorithm>

namespace meshalyzer {

FaceModels::FaceModels(const Soup& before, const Edits& edits, const SkippedOperations& skipped,
                       const EditedFaces& faces)
    : before_(before), edits_(edits), faces_(faces), turns_(faces.sources.size(), 0) {
  for (const Edits::ChangedFace& face : edits.changed_faces) {
    const Index now = faces.new_index[face.face];
    if (face.turns_normals && !skipped(face.op) && now != kNoIndex) turns_[now] = 1;
  }
  for (std::size_t f = 0; f < turns_.size(); ++f) {
    if (!is_old(f) && is_reversed(f) && normals_agree(before_, model_of(f))) turns_[f] = 1;
  }
}

const Edits::AddedFace& FaceModels::added(std::size_t face) const {
  return edits_.added_faces[faces_.sources[face] - before_.n_faces()];
}

bool FaceModels::is_old(std::size_t face) const {
  return faces_.sources[face] < before_.n_faces();
}

bool FaceModels::is_patch(std::size_t face) const {
  return !is_old(face) && added(face).fills_hole;
}

Index FaceModels::model_of(std::size_t face) const {
  return is_old(face) ? faces_.sources[face] : added(face).prototype;
}

bool FaceModels::is_reversed(std::size_t face) const {
  const Index model = model_of(face);
  if (!has_all_corners(before_.triangles[model])) return false;
  return direction_of(face).dot(angle_weighted_normal(corners_of(before_, model), 0)) < 0.0;
}

Vec3 FaceModels::direction_of(std::size_t face) const {
  return angle_weighted_normal(places_of(face), 0).stableNormalized();
}

Corners FaceModels::places_of(std::size_t face) const {
  const auto& [a, b, c] = triangles()[face];
  return {place_of(a), place_of(b), place_of(c)};
}

Index FaceModels::old_vertex(Index corner) const {
  const std::size_t n_old = before_.n_vertices();
  return corner < n_old ? corner : edits_.added_vertices[corner - n_old].copy_of;
}

const Vec3& FaceModels::place_of(Index corner) const {
  return edits_.position_of(before_, corner);
}

std::optional<Vec3> FaceModels::normal_at(std::size_t face, Index corner) const {
  const Index model = model_of(face);
  const Triangle& normals = before_.corner_normals[model];
  if (!has_all_corners(before_.triangles[model]) || !has_all_corners(normals)) return std::nullopt;
  const Vec3 normal = blended(blend_at(place_of(corner), corners_of(before_, model), normals));
  const Vec3 direction = (turns_normals(face) ? -1.0 : 1.0) * direction_of(face);
  return normal.dot(direction) < 0.0 ? direction : normal;
}

Vec3 FaceModels::blended(const Blend& blend) const {
  const Vec3& first = before_.normals[blend.items[0]];
  const bool is_flat = std::all_of(blend.items.begin(), blend.items.end(), [&](Index normal) {
    return normal == kNoIndex || before_.normals[normal] == first;
  });
  if (is_flat) return first;
  Vec3 mean;
  for (int axis = 0; axis < 3; ++axis) {
    mean[axis] = blend.mean([&](Index normal) { return before_.normals[normal][axis]; });
  }
  return mean.stableNormalized();
}

}  // namespace meshalyzer
