#include "meshalyzer/repair/replace/internal/mesh_operands.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/closest_point.h"

namespace meshalyzer {

Index MeshOperands::add_vertex(const Vec3& p) {
  soup_.positions.push_back(p);
  return static_cast<Index>(soup_.positions.size() - 1);
}

void MeshOperands::add(const Triangle& t, Index operand, Index origin) {
  soup_.triangles.push_back(t);
  of_face_.push_back(operand);
  origins_.push_back(origin);
}

void MeshOperands::add_solid(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                             Index operand) {
  const auto first = static_cast<Index>(soup_.positions.size());
  soup_.positions.insert(soup_.positions.end(), positions.begin(), positions.end());
  for (Triangle t : triangles) {
    for (Index& v : t) v += first;
    add(t, operand, kNoIndex);
  }
}

CombinedSolid MeshOperands::combine(std::size_t count, const InsideRule& rule,
                                    const CombineOptions& options) const {
  return combine_solids({.soup = soup_, .of_face = of_face_, .count = count}, rule, options);
}

CutSurface MeshOperands::surface_of(const CombinedSolid& solid, const PassInput& input) const {
  const ClosestPoints closest(input.mesh.tree());
  CutSurface surface;
  surface.positions = solid.positions;
  Index hint = kNoIndex;
  for (const CombinedFace& face : solid.faces) {
    Index origin = origins_[face.origin];
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
