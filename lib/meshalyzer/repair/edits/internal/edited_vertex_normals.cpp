#include "meshalyzer/repair/edits/internal/edited_vertex_normals.h"

#include "meshalyzer/base/triangle.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace meshalyzer {
namespace {

/// What the faces at a vertex say of its normal.
struct FacesAtVertex {
  /// The first of them that is part of no hole patch; kNoIndex if there is none.
  Index face = kNoIndex;
  bool has_patch = false;
  bool has_turned = false;
  bool has_unturned = false;
};

/// Returns, by vertex numbered as in Edits, what its faces say.
std::vector<FacesAtVertex> faces_at_vertices(const FaceModels& models) {
  std::vector<FacesAtVertex> result(models.before().n_vertices() +
                                    models.edits().added_vertices.size());
  for (std::size_t f = 0; f < models.triangles().size(); ++f) {
    for (const Index v : models.triangles()[f]) {
      if (v == kNoIndex) continue;
      FacesAtVertex& at = result[v];
      if (models.is_patch(f)) {
        at.has_patch = true;
        continue;
      }
      if (at.face == kNoIndex) at.face = static_cast<Index>(f);
      (models.turns_normals(f) ? at.has_turned : at.has_unturned) = true;
    }
  }
  return result;
}

/// Sets the normals of chosen vertices to the mean of those of their faces.
void set_means(const std::vector<std::uint8_t>& is_chosen, Soup& result) {
  for (std::size_t f = 0; f < result.n_faces(); ++f) {
    const Triangle& t = result.triangles[f];
    if (!has_all_corners(t)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      if (is_chosen[t[k]] == 0) continue;
      result.normals[t[k]] += angle_weighted_normal(corners_of(result, static_cast<Index>(f)), k);
    }
  }
  for (std::size_t v = 0; v < is_chosen.size(); ++v) {
    if (is_chosen[v] != 0) result.normals[v].stableNormalize();
  }
}

}  // namespace

void set_vertex_normals(const FaceModels& models, std::span<const Index> vertices, Soup& result) {
  const std::vector<FacesAtVertex> faces = faces_at_vertices(models);
  std::vector<std::uint8_t> needs_mean(vertices.size(), 0);
  bool is_any = false;
  result.normals.clear();
  result.normals.reserve(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const FacesAtVertex& at = faces[vertices[i]];
    const Index old = models.old_vertex(vertices[i]);
    std::optional<Vec3> normal;
    if (old != kNoIndex) {
      normal = models.before().normals[old];
    } else if (at.face != kNoIndex && !at.has_patch) {
      normal = models.normal_at(at.face, vertices[i]);
    }
    needs_mean[i] = normal ? 0 : 1;
    is_any = is_any || !normal;
    // The mean is that of the faces as they are now.
    if (normal && at.has_turned && !at.has_unturned) normal = -*normal;
    result.normals.push_back(normal.value_or(Vec3::Zero()));
  }
  if (is_any) set_means(needs_mean, result);
  result.corner_normals = result.triangles;
}

}  // namespace meshalyzer
