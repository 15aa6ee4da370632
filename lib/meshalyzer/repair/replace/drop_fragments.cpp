#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/repair/orient/bounds_solid.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// A fragment is small if its area is at most this fraction of that of the mesh.
constexpr double kSmallShare = 0.1;
/// A fragment is debris of a solid if its area, and the total area of all that hung on the solid,
/// is less than this fraction of the solid's.
constexpr double kDebrisShare = 0.01;
constexpr double kShareOfAllDebris = 0.05;

/// The components of the present mesh, by common edges.
struct SurfaceParts {
  Components components;
  /// #components.
  std::vector<double> areas;
  /// #mesh faces.
  std::vector<double> face_areas;
  /// #components.
  std::vector<std::uint8_t> is_closed;
  /// #components: 1 for those that bound a solid.
  std::vector<std::uint8_t> bounds;
};

SurfaceParts find_parts(const PassInput& input, Components components,
                        std::vector<std::uint8_t> is_closed) {
  const PreparedMesh& mesh = input.mesh;
  SurfaceParts parts{.components = std::move(components),
                     .areas = {},
                     .face_areas = {},
                     .is_closed = std::move(is_closed),
                     .bounds = {}};
  parts.areas.resize(parts.components.count);
  parts.face_areas.resize(parts.components.of_face.size());
  for (std::size_t f = 0; f < parts.components.of_face.size(); ++f) {
    const auto [a, b, c] = corners_of(mesh.soup(), mesh.cut().side.faces[f]);
    parts.face_areas[f] = accurate_normal(a, b, c).norm() / 2.0;
    parts.areas[parts.components.of_face[f]] += parts.face_areas[f];
  }
  parts.bounds = bounds_solid(mesh, parts.components, input.wants_to_stop);
  return parts;
}

/// #components: 1 for sheets, small ones or all.
std::vector<std::uint8_t> find_sheets(const SurfaceParts& parts, Fragments which) {
  const double total = std::accumulate(parts.areas.begin(), parts.areas.end(), 0.0);
  std::vector<std::uint8_t> is_dropped(parts.components.count, 0);
  bool is_any_kept = false;
  for (std::size_t i = 0; i < is_dropped.size(); ++i) {
    const bool is_wanted = which == Fragments::All || parts.areas[i] <= kSmallShare * total;
    is_dropped[i] = parts.is_closed[i] == 0 && parts.bounds[i] == 0 && is_wanted ? 1 : 0;
    // Small sheets are not dropped for the sake of large ones that enclose nothing either, once
    // these have had their chance to be closed.
    is_any_kept =
        is_any_kept || (which == Fragments::All ? parts.bounds[i] != 0 : is_dropped[i] == 0);
  }
  if (!is_any_kept) is_dropped.assign(is_dropped.size(), 0);
  return is_dropped;
}

/// #mesh faces: the component of the original that contained the face, or the face that it was made
/// of; kNoIndex for faces of hole patches.
std::vector<Index> find_origins(const PassInput& input) {
  const CutMesh original = build(input.original);
  const std::vector<Index> component_of =
      components_of_file_faces(original, find_components(original), input.original.n_faces());
  std::vector<Index> origins;
  for (const Index face : input.mesh.cut().side.faces) {
    const Index origin = input.tracked.origin_of_face(face);
    origins.push_back(origin == kNoIndex ? kNoIndex : component_of[origin]);
  }
  return origins;
}

/// #components: 1 for sheets that hung, in the original, on parts that bound a solid and are much
/// larger than all of these sheets, and for those in which only hole patches are left.
std::vector<std::uint8_t> find_debris(const PassInput& input, const SurfaceParts& parts) {
  const std::vector<Index> origins = find_origins(input);
  const std::vector<Index>& part_of = parts.components.of_face;
  std::vector<std::uint8_t> is_debris(parts.components.count);
  for (std::size_t i = 0; i < is_debris.size(); ++i) {
    is_debris[i] = parts.is_closed[i] == 0 && parts.bounds[i] == 0 ? 1 : 0;
  }
  /// The area of the faces made of each component of the original.
  std::vector<double> solid_areas(input.original.n_faces(), 0.0);
  std::vector<double> sheet_areas(input.original.n_faces(), 0.0);
  for (std::size_t f = 0; f < part_of.size(); ++f) {
    if (origins[f] == kNoIndex) continue;
    (is_debris[part_of[f]] != 0 ? sheet_areas : solid_areas)[origins[f]] += parts.face_areas[f];
  }
  for (std::size_t f = 0; f < part_of.size(); ++f) {
    const Index origin = origins[f];
    if (origin == kNoIndex) continue;
    const bool is_small = parts.areas[part_of[f]] < kDebrisShare * solid_areas[origin] &&
                          sheet_areas[origin] < kShareOfAllDebris * solid_areas[origin];
    if (!is_small) is_debris[part_of[f]] = 0;
  }
  return is_debris;
}

}  // namespace

PassResult drop_fragments(const PassInput& input, Fragments which) {
  Components components = find_edge_components(input.mesh.cut());
  std::vector<std::uint8_t> is_closed = which_are_closed(input.mesh.cut(), components);
  if (std::find(is_closed.begin(), is_closed.end(), 0) == is_closed.end()) return {};
  // The last part of a mesh stays.
  if (components.count < 2) return {};
  const SurfaceParts parts = find_parts(input, std::move(components), std::move(is_closed));
  const std::vector<std::uint8_t> is_dropped =
      which == Fragments::Debris ? find_debris(input, parts) : find_sheets(parts, which);
  const std::size_t n = parts.components.count;
  PassResult result;
  const ItemsByGroup faces(parts.components.of_face, n);
  for (std::size_t i = 0; i < n; ++i) {
    if (is_dropped[i] == 0) continue;
    const Index op = result.edits.begin_operation();
    for (const Index f : faces[i]) {
      const Index face = input.mesh.cut().side.faces[f];
      result.edits.removed_faces.push_back({op, face});
      result.edits.interior_walls.push_back({op, {corners_of(input.tracked.soup, face)}});
    }
  }
  return result;
}

}  // namespace meshalyzer
