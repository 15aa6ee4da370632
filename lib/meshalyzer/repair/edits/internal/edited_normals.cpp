#include "meshalyzer/repair/edits/internal/edited_normals.h"

#include "meshalyzer/io/references.h"
#include "meshalyzer/repair/edits/internal/edited_corner_normals.h"
#include "meshalyzer/repair/edits/internal/edited_vertex_normals.h"

#include <algorithm>
#include <vector>

namespace meshalyzer {
namespace {

/// Replaces all normals of the corners at a vertex by one new normal.
void change_normals(const Edits& edits, const SkippedOperations& skipped,
                    std::span<const Index> vertices, Soup& result) {
  const bool one_a_vertex = has_vertex_normals(result);
  std::vector<Index> new_normal;
  for (const Edits::ChangedNormal& change : edits.changed_normals) {
    const auto found = std::lower_bound(vertices.begin(), vertices.end(), change.vertex);
    if (skipped(change.op) || found == vertices.end() || *found != change.vertex) continue;
    const auto v = static_cast<std::size_t>(found - vertices.begin());
    if (one_a_vertex) {
      result.normals[v] = change.normal;
      continue;
    }
    new_normal.resize(result.n_vertices(), kNoIndex);
    new_normal[v] = static_cast<Index>(result.normals.size());
    result.normals.push_back(change.normal);
  }
  if (new_normal.empty()) return;
  for (std::size_t f = 0; f < result.n_faces(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = result.triangles[f][k];
      Index& normal = result.corner_normals[f][k];
      if (v != kNoIndex && normal != kNoIndex && new_normal[v] != kNoIndex) normal = new_normal[v];
    }
  }
}

}  // namespace

void set_edited_normals(const Soup& before, const Edits& edits, const SkippedOperations& skipped,
                        const EditedFaces& faces, std::span<const Index> vertices, Soup& result) {
  if (before.corner_normals.empty()) {
    result.normals = before.normals;
    return;
  }
  const FaceModels models(before, edits, skipped, faces);
  if (has_vertex_normals(before)) {
    set_vertex_normals(models, vertices, result);
  } else {
    set_corner_normals(models, result);
  }
  change_normals(edits, skipped, vertices, result);
}

}  // namespace meshalyzer
