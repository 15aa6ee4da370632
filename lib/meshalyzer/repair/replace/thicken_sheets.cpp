#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/exact/plane_view.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/repair/orient/bounds_solid.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/replace/internal/thick_surface.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
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
std::vector<Index> distinct_faces(const Soup& soup, std::span<const Index> faces) {
  std::vector<Index> distinct;
  std::set<Triangle> known;
  for (const Index face : faces) {
    const auto [a, b, c] = corners_of(soup, face);
    if (are_collinear(a, b, c)) continue;
    Triangle sorted = soup.triangles[face];
    std::sort(sorted.begin(), sorted.end());
    if (known.insert(sorted).second) distinct.push_back(face);
  }
  return distinct;
}

/// Returns a view along the normal of the plane in which all of the faces lie, if they do.
std::optional<PlaneView> view_of_plane(const Soup& soup, std::span<const Index> faces) {
  std::optional<PlaneView> view;
  Corners first;
  for (const Index face : faces) {
    const auto [a, b, c] = corners_of(soup, face);
    const std::optional<Axis> axis = projection_axis(a, b, c);
    if (!axis) continue;
    first = {a, b, c};
    view = {*axis, orient2d(*axis, a, b, c)};
    break;
  }
  const auto is_in_plane = [&](Index v) {
    return orient3d(first[0], first[1], first[2], soup.positions[v]) == 0;
  };
  const bool are_all = view && std::all_of(faces.begin(), faces.end(), [&](Index face) {
                         const Triangle& t = soup.triangles[face];
                         return std::all_of(t.begin(), t.end(), is_in_plane);
                       });
  return are_all ? view : std::nullopt;
}

/// Returns the faces of a sheet, of which two with the same vertices count as one; of a closed
/// surface those of one side, if all of it lies in a plane, else none.
///
/// @param faces  Of one component.
std::vector<Index> faces_of_sheet(const Soup& soup, std::vector<Index> faces, bool is_closed) {
  if (is_closed) {
    const std::optional<PlaneView> view = view_of_plane(soup, faces);
    if (!view) return {};
    std::erase_if(faces, [&](Index face) {
      const auto [a, b, c] = corners_of(soup, face);
      return view->turn(a, b, c) <= 0;
    });
  }
  return distinct_faces(soup, faces);
}

/// @param faces  Those of a component.
/// @param sheet  Those of them that become the thin solid.
void propose(const PassInput& input, std::span<const Index> faces, std::span<const Index> sheet,
             double thickness, Edits& edits) {
  const ThickSurface made = thicken(input.tracked.soup, sheet, thickness);
  const Index op = edits.begin_operation();
  const auto first =
      static_cast<Index>(input.tracked.soup.n_vertices() + edits.added_vertices.size());
  for (const Index face : faces) edits.removed_faces.push_back({op, face});
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
  const ItemsByGroup faces(components.of_face, components.count);
  PassResult result;
  for (std::size_t i = 0; i < components.count; ++i) {
    std::vector<Index> part;
    for (const Index f : faces[i]) part.push_back(input.mesh.cut().side.faces[f]);
    const std::vector<Index> sheet = faces_of_sheet(input.tracked.soup, part, is_sheet[i] == 0);
    if (!sheet.empty()) propose(input, part, sheet, thickness, result.edits);
  }
  return result;
}

PassResult thicken_parts(const PassInput& input, std::span<const Index> face_keys,
                         double thickness) {
  const Components components = find_edge_components(input.mesh.cut());
  const ItemsByGroup faces(components.of_face, components.count);
  const auto is_named = [&](Index face) {
    return std::binary_search(face_keys.begin(), face_keys.end(), input.tracked.face_keys[face]);
  };
  PassResult result;
  for (std::size_t i = 0; i < components.count; ++i) {
    std::vector<Index> part;
    for (const Index f : faces[i]) part.push_back(input.mesh.cut().side.faces[f]);
    if (std::none_of(part.begin(), part.end(), is_named)) continue;
    propose(input, part, distinct_faces(input.tracked.soup, part), thickness, result.edits);
  }
  return result;
}

}  // namespace meshalyzer
