#include "meshalyzer/repair/edits/internal/edited_vertex_normals.h"

#include "meshalyzer/base/triangle.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace meshalyzer {
namespace {

/// What the faces at a vertex say of its normal.
struct FacesAtVertex {
  /// Whether any face that is not part of a hole patch turns its normals, or does not.
  bool has_turned = false;
  bool has_unturned = false;
  /// Only at new vertices: the sum of the normals of the faces there, times their angles.
  Vec3 sum = Vec3::Zero();
  /// The normal of the first of them, and whether others have another one.
  Vec3 first = Vec3::Zero();
  bool is_first_only = true;

  void add(const Vec3& normal, double angle) {
    if (first.isZero(0.0)) first = normal;
    is_first_only = is_first_only && normal == first;
    sum += angle * normal;
  }
  [[nodiscard]] Vec3 mean() const { return is_first_only ? first : sum.stableNormalized(); }
};

/// Adds what a face says of the normal of a new vertex at one of its corners.
void add_normal(const FaceModels& models, std::size_t face, std::size_t k, FacesAtVertex& at) {
  const Vec3 weighted = angle_weighted_normal(models.places_of(face), k);
  const double angle = weighted.norm();
  if (angle == 0.0) return;
  std::optional<Vec3> normal;
  if (!models.is_patch(face)) normal = models.normal_at(face, models.triangles()[face][k]);
  if (!normal) {
    at.add(weighted / angle, angle);
  } else {
    at.add(models.turns_normals(face) ? Vec3(-*normal) : *normal, angle);
  }
}

/// Returns, by vertex numbered as in Edits, what its faces say.
std::vector<FacesAtVertex> faces_at_vertices(const FaceModels& models) {
  std::vector<FacesAtVertex> result(models.before().n_vertices() +
                                    models.edits().added_vertices.size());
  for (std::size_t f = 0; f < models.triangles().size(); ++f) {
    const Triangle& t = models.triangles()[f];
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] == kNoIndex) continue;
      FacesAtVertex& at = result[t[k]];
      if (models.old_vertex(t[k]) == kNoIndex && has_all_corners(t)) add_normal(models, f, k, at);
      if (models.is_patch(f)) continue;
      (models.turns_normals(f) ? at.has_turned : at.has_unturned) = true;
    }
  }
  return result;
}

}  // namespace

void set_vertex_normals(const FaceModels& models, std::span<const Index> vertices, Soup& result) {
  const std::vector<FacesAtVertex> faces = faces_at_vertices(models);
  result.normals.clear();
  result.normals.reserve(vertices.size());
  for (const Index v : vertices) {
    const FacesAtVertex& at = faces[v];
    const Index old = models.old_vertex(v);
    if (old == kNoIndex) {
      result.normals.push_back(at.mean());
    } else {
      const Vec3& normal = models.before().normals[old];
      result.normals.push_back(at.has_turned && !at.has_unturned ? Vec3(-normal) : normal);
    }
  }
  result.corner_normals = result.triangles;
}

}  // namespace meshalyzer
