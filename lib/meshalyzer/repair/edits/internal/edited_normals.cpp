#include "meshalyzer/repair/edits/internal/edited_normals.h"

#include "meshalyzer/io/references.h"
#include "meshalyzer/repair/edits/internal/edited_corner_normals.h"
#include "meshalyzer/repair/edits/internal/edited_vertex_normals.h"

#include <algorithm>
#include <array>
#include <vector>

namespace meshalyzer {
namespace {

/// Changes the normals of corners of faces at a vertex. The normals of the soup before the edits
/// still have their numbers, unless each vertex has one.
void change_normals(const Edits& edits, const SkippedOperations& skipped,
                    std::span<const Index> vertices, Soup& result) {
  const bool one_a_vertex = has_vertex_normals(result);
  // Sorted: the vertex and the normal of it that is replaced, and the new one.
  std::vector<std::array<Index, 3>> changes;
  for (const Edits::ChangedNormal& change : edits.changed_normals) {
    const auto found = std::lower_bound(vertices.begin(), vertices.end(), change.vertex);
    if (skipped(change.op) || found == vertices.end() || *found != change.vertex) continue;
    const auto v = static_cast<Index>(found - vertices.begin());
    if (one_a_vertex) {
      result.normals[v] = change.normal;
      continue;
    }
    changes.push_back({v, change.replaced, static_cast<Index>(result.normals.size())});
    result.normals.push_back(change.normal);
  }
  if (changes.empty()) return;
  std::sort(changes.begin(), changes.end());
  for (std::size_t f = 0; f < result.n_faces(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      Index& normal = result.corner_normals[f][k];
      const std::array<Index, 3> first{result.triangles[f][k], normal, 0};
      const auto found = std::lower_bound(changes.begin(), changes.end(), first);
      if (found == changes.end() || (*found)[0] != first[0] || (*found)[1] != normal) continue;
      normal = (*found)[2];
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
