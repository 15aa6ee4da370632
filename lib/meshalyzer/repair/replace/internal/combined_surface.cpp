#include "meshalyzer/repair/replace/internal/combined_surface.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/closest_point.h"

namespace meshalyzer {

CutSurface surface_of_combined(const PassInput& input, const CombinedSolid& solid,
                               std::span<const Index> origins) {
  const ClosestPoints closest(input.mesh.tree());
  CutSurface surface;
  surface.positions = solid.positions;
  Index hint = kNoIndex;
  for (const CombinedFace& face : solid.faces) {
    Index origin = origins[face.origin];
    if (origin == kNoIndex) {
      const auto [a, b, c] = face.corners;
      const auto found = closest.find(
          {.point = centroid_of({solid.positions[a], solid.positions[b], solid.positions[c]}),
           .hint = hint});
      hint = found->slot;
      origin = input.mesh.cut().side.faces[found->mesh_face];
    }
    surface.triangles.push_back(face.corners);
    surface.origins.push_back(origin);
  }
  return surface;
}

}  // namespace meshalyzer
