#include "meshalyzer/repair/replace/internal/new_surface.h"

#include <cstddef>

namespace meshalyzer {

Index replace_faces(const Soup& soup, std::span<const Index> faces, const NewSurface& surface,
                    Edits& edits) {
  const Index op = edits.begin_operation();
  const auto first = static_cast<Index>(soup.n_vertices() + edits.added_vertices.size());
  for (const Index face : faces) edits.removed_faces.push_back({op, face});
  for (const Vec3& p : surface.positions) edits.added_vertices.push_back({op, p});
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    Triangle t = surface.triangles[i];
    for (Index& corner : t) corner += first;
    edits.added_faces.push_back({op, t, surface.origins[i]});
  }
  return op;
}

}  // namespace meshalyzer
