#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/exact/plane_view.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/repair/orient/bounds_solid.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/replace/internal/new_surface.h"
#include "meshalyzer/repair/replace/internal/thick_surface.h"
#include "meshalyzer/repair/replace/internal/thicken_parts.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// #components: 1 for those that bound no solid, or cannot be oriented.
std::vector<std::uint8_t> which_are_sheets(const PreparedMesh& mesh, const Components& components) {
  std::vector<std::uint8_t> is_sheet = bounds_solid(mesh, components);
  for (std::uint8_t& flag : is_sheet) flag = flag == 0 ? 1 : 0;
  const CutMesh& cut = mesh.cut();
  for (const HalfedgeHandle h : cut.side.flipped_edges.halfedges) {
    is_sheet[components.of(cut.mesh, h)] = 1;
  }
  return is_sheet;
}

/// Returns the faces that have an area, of those with the same vertices the first.
std::vector<Index> distinct_faces(const Soup& soup, std::span<const Index> faces) {
  std::vector<Index> distinct;
  std::set<Triangle> known;
  for (const Index face : faces) {
    if (are_collinear(corners_of(soup, face))) continue;
    if (known.insert(sorted_corners(soup.triangles[face])).second) distinct.push_back(face);
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

/// Makes a thin solid of each component, each in an operation of its own.
///
/// @param separable  Ascending, see thicken().
/// @param sheet_of   Returns those faces of a component, by its number and its faces, that become
///                  the thin solid; none if it is left.
template <typename SheetOf>
PassResult thicken_components(const PassInput& input, const Components& components,
                              double thickness, std::span<const Index> separable,
                              const SheetOf& sheet_of) {
  const Soup& soup = input.tracked.soup;
  const ItemsByGroup faces(components.of_face, components.count);
  PassResult result;
  for (std::size_t i = 0; i < components.count; ++i) {
    std::vector<Index> part;
    for (const Index f : faces[i]) part.push_back(input.mesh.cut().side.faces[f]);
    const std::vector<Index> sheet = sheet_of(i, part);
    if (sheet.empty()) continue;
    replace_faces(soup, part, thicken(soup, sheet, thickness, separable), result.edits);
  }
  return result;
}

}  // namespace

PassResult thicken_sheets(const PassInput& input, double thickness) {
  const Components components = find_edge_components(input.mesh.cut());
  const std::vector<std::uint8_t> is_sheet = which_are_sheets(input.mesh, components);
  return thicken_components(input, components, thickness, {},
                            [&](std::size_t i, const std::vector<Index>& part) {
                              return faces_of_sheet(input.tracked.soup, part, is_sheet[i] == 0);
                            });
}

PassResult thicken_parts(const PassInput& input, std::span<const Index> face_keys,
                         std::span<const Index> separable_keys, double thickness) {
  const auto is_one_of = [&](std::span<const Index> keys, Index face) {
    return std::binary_search(keys.begin(), keys.end(), input.tracked.face_keys[face]);
  };
  const auto is_named = [&](Index face) { return is_one_of(face_keys, face); };
  std::vector<Index> separable;
  for (Index face = 0; face < input.tracked.soup.n_faces(); ++face) {
    if (is_one_of(separable_keys, face)) separable.push_back(face);
  }
  return thicken_components(input, find_edge_components(input.mesh.cut()), thickness, separable,
                            [&](std::size_t, const std::vector<Index>& part) {
                              return std::any_of(part.begin(), part.end(), is_named)
                                         ? distinct_faces(input.tracked.soup, part)
                                         : std::vector<Index>();
                            });
}

}  // namespace meshalyzer
