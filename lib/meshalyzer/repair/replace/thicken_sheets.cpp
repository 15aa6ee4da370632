#include "meshalyzer/exact/normal.h"
#include "meshalyzer/repair/orient/bounds_solid.h"
#include "meshalyzer/repair/orient/internal/side_votes.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/replace/internal/thick_surface.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

/// #components: 1 for those that bound no solid, or cannot be oriented.
std::vector<std::uint8_t> which_are_sheets(const PreparedMesh& mesh, const Components& components) {
  std::vector<std::uint8_t> is_sheet = bounds_solid(mesh, components);
  for (std::uint8_t& flag : is_sheet) flag = flag == 0 ? 1 : 0;
  const CutMesh& cut = mesh.cut();
  const auto mark = [&](const CutEdges& edges) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const FaceHandle f = cut.mesh.face_handle(edges[i].halfedges.front());
      is_sheet[components.of_face[static_cast<std::size_t>(f.idx())]] = 1;
    }
  };
  mark(cut.side.flipped_edges);
  return is_sheet;
}

/// Returns the faces that have an area, of those with the same vertices the first.
std::vector<Index> distinct_faces(const PassInput& input, std::span<const Index> mesh_faces) {
  std::vector<Index> faces;
  std::set<Triangle> known;
  for (const Index f : mesh_faces) {
    const Index face = input.mesh.cut().side.faces[f];
    const auto [a, b, c] = corners_of(input.tracked.soup, face);
    if (accurate_normal(a, b, c).isZero(0.0)) continue;
    Triangle sorted = input.tracked.soup.triangles[face];
    std::sort(sorted.begin(), sorted.end());
    if (known.insert(sorted).second) faces.push_back(face);
  }
  return faces;
}

void propose(const PassInput& input, std::span<const Index> mesh_faces, double thickness,
             Edits& edits) {
  const std::vector<Index> faces = distinct_faces(input, mesh_faces);
  if (faces.empty()) return;
  const ThickSurface made = thicken(input.tracked.soup, faces, thickness);
  const Index op = edits.begin_operation();
  const auto first =
      static_cast<Index>(input.tracked.soup.n_vertices() + edits.added_vertices.size());
  for (const Index f : mesh_faces) {
    edits.removed_faces.push_back({op, input.mesh.cut().side.faces[f]});
  }
  for (const Vec3& p : made.positions) edits.added_vertices.push_back({op, p});
  for (std::size_t i = 0; i < made.triangles.size(); ++i) {
    Triangle t = made.triangles[i];
    for (Index& corner : t) corner += first;
    edits.added_faces.push_back({op, t, made.origins[i]});
  }
}

}  // namespace

PassResult thicken_sheets(const PassInput& input, double thickness) {
  const Components components = find_edge_components(input.mesh.cut());
  const std::vector<std::uint8_t> is_sheet = which_are_sheets(input.mesh, components);
  const FacesByPart faces(components.of_face, components.count);
  PassResult result;
  for (std::size_t i = 0; i < components.count; ++i) {
    if (is_sheet[i] != 0) propose(input, faces.of(i), thickness, result.edits);
  }
  return result;
}

}  // namespace meshalyzer
