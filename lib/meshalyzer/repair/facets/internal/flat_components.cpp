#include "meshalyzer/repair/facets/internal/flat_components.h"

#include "meshalyzer/spatial/closest_point.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>

namespace meshalyzer {
namespace {

/// Returns the number of faces of each component that are not thin.
std::vector<Index> count_others(const Components& components, const SideTable& side,
                                std::span<const Index> thin_faces) {
  std::vector<Index> n_others(components.count, 0);
  for (const Index component : components.of_face) ++n_others[component];
  for (const Index f : thin_faces) --n_others[components.of_face[side.mesh_face(f)]];
  return n_others;
}

/// Returns the positions of the vertices of some faces.
std::vector<Vec3> places_of(const Soup& soup, const std::vector<Index>& faces) {
  std::vector<Vec3> places;
  for (const Index f : faces) {
    for (const Index v : soup.triangles[f]) places.push_back(soup.positions[v]);
  }
  return places;
}

/// Tells which faces are near to the rest of the mesh.
class RestOfMesh {
 public:
  RestOfMesh(const PassInput& input, const std::vector<Index>& without)
      : closest_(input.mesh.tree()),
        is_excluded_(input.mesh.cut().mesh.n_faces(), 0),
        within_(input.limits.max_deviation) {
    for (const Index f : without) is_excluded_[input.mesh.cut().side.mesh_face(f)] = 1;
  }

  [[nodiscard]] bool are_near(const std::vector<Vec3>& places) const {
    return std::all_of(places.begin(), places.end(), [&](const Vec3& p) {
      return closest_.find({.point = p, .within = within_, .excluded = is_excluded_}).has_value();
    });
  }

 private:
  ClosestPoints closest_;
  std::vector<std::uint8_t> is_excluded_;
  double within_;
};

}  // namespace

FlatComponents find_flat_components(const PassInput& input, std::span<const Index> thin_faces) {
  const CutMesh& cut = input.mesh.cut();
  const Components components = find_edge_components(cut);
  const std::vector<Index> n_others = count_others(components, cut.side, thin_faces);
  FlatComponents flat;
  std::map<Index, std::vector<Index>> faces_of;
  for (const Index f : thin_faces) {
    const Index component = components.of_face[cut.side.mesh_face(f)];
    if (n_others[component] != 0) continue;
    flat.faces.push_back(f);
    faces_of[component].push_back(f);
  }
  if (faces_of.empty()) return flat;
  const RestOfMesh rest(input, flat.faces);
  for (const auto& [component, faces] : faces_of) {
    if (rest.are_near(places_of(input.tracked.soup, faces))) flat.needless.push_back(faces);
  }
  return flat;
}

}  // namespace meshalyzer
