#include "meshalyzer/repair/facets/internal/flat_components.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/geometry/face_measures.h"
#include "meshalyzer/geometry/volume.h"
#include "meshalyzer/prepared/shells.h"
#include "meshalyzer/spatial/closest_point.h"
#include "meshalyzer/spatial/face_tree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>

namespace meshalyzer {
namespace {

/// Returns twice the volume of each part by its area: of two layers that lie on each other, the
/// mean distance between them.
std::vector<double> mean_thickness(const CutMesh& cut, const FaceParts& parts) {
  const std::vector<SignedVolume> volumes =
      signed_volumes(cut.mesh, parts, bounding_boxes(cut.mesh, parts));
  std::vector<double> areas(parts.count, 0.0);
  for (std::size_t f = 0; f < parts.of_face.size(); ++f) {
    if (parts.of_face[f] == kNoIndex) continue;
    const Corners corners = face_corners(cut.mesh, FaceHandle(static_cast<int>(f)));
    areas[parts.of_face[f]] += normal_of(corners).stableNorm() / 2.0;
  }
  std::vector<double> thickness(parts.count);
  for (std::size_t c = 0; c < parts.count; ++c) {
    thickness[c] = 2.0 * std::abs(volumes[c].value) / areas[c];
  }
  return thickness;
}

/// Returns the corners of some faces, and points between them.
std::vector<Vec3> places_of(const Soup& soup, const std::vector<Index>& faces) {
  std::vector<Vec3> places;
  for (const Index f : faces) {
    const Corners t = corners_of(soup, f);
    places.insert(places.end(), t.begin(), t.end());
    for (std::size_t k = 0; k < 3; ++k) places.push_back(t[k] / 2 + t[(k + 1) % 3] / 2);
    places.push_back(centroid_without_overflow(t));
  }
  return places;
}

/// Tells which faces are near to the rest of the mesh. It has a tree of its own: in that of all
/// faces, each search would visit all that are left out, and these may be nearly all.
class RestOfMesh {
 public:
  /// @param rest  The mesh faces of the rest, ascending.
  RestOfMesh(const PassInput& input, const std::vector<Index>& rest)
      : tree_(input.mesh.cut(), rest), within_(input.limits.max_deviation) {}

  [[nodiscard]] bool are_near(const std::vector<Vec3>& places) const {
    return std::all_of(places.begin(), places.end(), [&](const Vec3& p) {
      return closest_.find({.point = p, .within = within_, .near_enough = within_}).has_value();
    });
  }

 private:
  FaceTree tree_;
  ClosestPoints closest_{tree_};
  double within_;
};

/// Returns the faces of each of some components that is near to the rest of the mesh, without all
/// of these components.
///
/// @param is_one  #components: whether each is one of them.
std::vector<std::vector<Index>> find_near_rest(const PassInput& input, const Components& components,
                                               const std::vector<std::uint8_t>& is_one) {
  std::map<Index, std::vector<Index>> faces_of;
  std::vector<Index> rest;
  for (Index f = 0; f < components.of_face.size(); ++f) {
    const Index component = components.of_face[f];
    if (is_one[component] == 0) {
      rest.push_back(f);
    } else {
      faces_of[component].push_back(input.mesh.cut().side.faces[f]);
    }
  }
  std::vector<std::vector<Index>> near;
  if (faces_of.empty()) return near;
  const RestOfMesh surface(input, rest);
  for (const auto& [component, faces] : faces_of) {
    if (input.wants_to_stop()) break;
    if (surface.are_near(places_of(input.tracked.soup, faces))) near.push_back(faces);
  }
  return near;
}

}  // namespace

ThinComponents count_thin_faces(const CutMesh& cut, std::span<const Index> thin_faces) {
  ThinComponents counted{.components = find_edge_components(cut), .n_faces = {}, .n_thin = {}};
  const Components& components = counted.components;
  counted.n_faces.assign(components.count, 0);
  counted.n_thin.assign(components.count, 0);
  for (const Index component : components.of_face) ++counted.n_faces[component];
  for (const Index f : thin_faces) ++counted.n_thin[components.of_face[cut.side.mesh_face(f)]];
  return counted;
}

FlatComponents find_flat_components(const PassInput& input, std::span<const Index> thin_faces,
                                    const ThinComponents& counted) {
  const auto& [components, n_faces, n_thin] = counted;
  std::vector<std::uint8_t> is_flat(components.count);
  for (std::size_t c = 0; c < components.count; ++c) is_flat[c] = n_thin[c] == n_faces[c] ? 1 : 0;
  FlatComponents flat;
  for (const Index f : thin_faces) {
    const std::size_t mesh_face = input.mesh.cut().side.mesh_face(f);
    if (is_flat[components.of_face[mesh_face]] != 0) flat.faces.push_back(f);
  }
  flat.needless = find_near_rest(input, components, is_flat);
  return flat;
}

std::vector<std::vector<Index>> find_needless_layers(const PassInput& input,
                                                     const ThinComponents& counted) {
  const CutMesh& cut = input.mesh.cut();
  const auto& [components, n_faces, n_thin] = counted;
  const std::vector<std::uint8_t> is_closed = which_are_shells(cut, components);
  std::vector<Index> part_of_face(components.of_face.size(), kNoIndex);
  for (std::size_t f = 0; f < part_of_face.size(); ++f) {
    const Index c = components.of_face[f];
    if (is_closed[c] != 0 && n_thin[c] != 0 && n_thin[c] != n_faces[c]) part_of_face[f] = c;
  }
  const std::vector<double> thickness =
      mean_thickness(cut, {.of_face = part_of_face, .count = components.count});
  std::vector<std::uint8_t> is_flat(components.count);
  for (std::size_t c = 0; c < components.count; ++c) {
    // That of other components is not a number.
    is_flat[c] = thickness[c] < input.tolerances.degeneracy ? 1 : 0;
  }
  return find_near_rest(input, components, is_flat);
}

}  // namespace meshalyzer
