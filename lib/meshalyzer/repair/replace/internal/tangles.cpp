#include "meshalyzer/repair/replace/internal/tangles.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace meshalyzer {
namespace {

class TangleSearch {
 public:
  TangleSearch(const PreparedMesh& mesh, const TangleLimits& limits,
               std::span<const Index> refilled)
      : mesh_(mesh),
        soup_(mesh.soup()),
        limits_(limits),
        is_refilled_(soup_.n_faces(), 0),
        is_of_refilled_(soup_.n_vertices(), 0),
        is_taken_(soup_.n_faces(), 0),
        joined_(soup_.n_vertices()) {
    for (const Index face : refilled) {
      is_refilled_[face] = 1;
      for (const Index v : soup_.triangles[face]) is_of_refilled_[v] = 1;
    }
  }

  Tangles run() {
    for (const IntersectingPair& pair : mesh_.intersecting_pairs()) {
      // What intersects a face of a refilled place belongs to the place.
      if (is_refilled_[pair.face_a] != 0) continue;
      is_taken_[pair.face_a] = 1;
      is_taken_[pair.face_b] = 1;
    }
    for (std::size_t ring = 0; ring < limits_.n_rings; ++ring) take_ring();
    group();
    if (places_.empty()) return {};
    take_what_is_cut_off();
    group();
    if (places_.empty()) return {};
    Soup rest = without_places();
    return {std::move(places_), std::move(rest)};
  }

 private:
  template <typename Function>
  void for_each_taken(const Function& function) const {
    for (Index face = 0; face < soup_.n_faces(); ++face) {
      if (is_taken_[face] != 0) function(face);
    }
  }

  void take_ring() {
    std::vector<std::uint8_t> is_reached(soup_.n_vertices(), 0);
    for_each_taken([&](Index face) {
      for (const Index v : soup_.triangles[face]) is_reached[v] = 1;
    });
    for (const Index face : mesh_.cut().side.faces) {
      if (is_refilled_[face] == 0 && has_corner_of(face, is_reached)) is_taken_[face] = 1;
    }
  }

  /// @param vertices  #V: 1 for those that are meant.
  [[nodiscard]] bool has_corner_of(Index face, const std::vector<std::uint8_t>& vertices) const {
    const Triangle& t = soup_.triangles[face];
    return std::any_of(t.begin(), t.end(), [&](Index v) { return vertices[v] != 0; });
  }

  /// Groups the faces that are taken. Those that have a vertex in common, or intersect, belong to
  /// one place.
  void group() {
    for_each_taken([&](Index face) {
      const Triangle& t = soup_.triangles[face];
      joined_.unite(t[0], t[1]);
      joined_.unite(t[0], t[2]);
    });
    for (const IntersectingPair& pair : mesh_.intersecting_pairs()) {
      if (is_refilled_[pair.face_a] != 0) continue;
      joined_.unite(soup_.triangles[pair.face_a][0], soup_.triangles[pair.face_b][0]);
    }
    places_.clear();
    std::vector<Index> place_of(soup_.n_vertices(), kNoIndex);
    for_each_taken([&](Index face) {
      Index& place = place_of[joined_.find(soup_.triangles[face][0])];
      if (place == kNoIndex) {
        place = static_cast<Index>(places_.size());
        places_.emplace_back();
      }
      places_[place].push_back(face);
    });
    std::erase_if(places_, [&](const std::vector<Index>& faces) {
      if (faces.size() <= limits_.max_faces && is_of_one_component(faces) &&
          is_apart_from_refilled(faces)) {
        return false;
      }
      for (const Index face : faces) is_taken_[face] = 0;
      return true;
    });
  }

  [[nodiscard]] bool is_of_one_component(const std::vector<Index>& faces) const {
    const auto component_of = [&](Index face) {
      return mesh_.components().of_face[mesh_.cut().side.mesh_face(face)];
    };
    return std::all_of(faces.begin(), faces.end(), [&](Index face) {
      return component_of(face) == component_of(faces.front());
    });
  }

  [[nodiscard]] bool is_apart_from_refilled(const std::vector<Index>& faces) const {
    return std::none_of(faces.begin(), faces.end(),
                        [&](Index face) { return has_corner_of(face, is_of_refilled_); });
  }

  [[nodiscard]] Soup without_places() const {
    Soup rest;
    rest.positions = soup_.positions;
    rest.triangles = soup_.triangles;
    for (Index face = 0; face < soup_.n_faces(); ++face) {
      if (is_taken_[face] != 0 || is_refilled_[face] != 0) rest.triangles[face] = kNoTriangle;
    }
    return rest;
  }

  /// Takes all that is left of a component but its largest part, where that is small: a bubble, or
  /// the tip of a spike. A component of which nothing is left is not taken.
  void take_what_is_cut_off() {
    const CutMesh cut = build(without_places());
    const Components parts = find_edge_components(cut);
    const Components& whole = mesh_.components();
    std::vector<std::size_t> n_faces(parts.count, 0);
    for (const Index part : parts.of_face) ++n_faces[part];
    const auto component_of = [&](Index face) {
      return whole.of_face[mesh_.cut().side.mesh_face(face)];
    };
    std::vector<Index> largest(whole.count, kNoIndex);
    for (std::size_t f = 0; f < parts.of_face.size(); ++f) {
      Index& found = largest[component_of(cut.side.faces[f])];
      const Index part = parts.of_face[f];
      if (found == kNoIndex || n_faces[part] > n_faces[found]) found = part;
    }
    for_each_taken([&](Index face) {
      if (largest[component_of(face)] == kNoIndex) is_taken_[face] = 0;
    });
    for (std::size_t f = 0; f < parts.of_face.size(); ++f) {
      const Index part = parts.of_face[f];
      const Index face = cut.side.faces[f];
      const bool is_cut_off = part != largest[component_of(face)];
      if (is_cut_off && n_faces[part] <= limits_.max_faces) is_taken_[face] = 1;
    }
  }

  const PreparedMesh& mesh_;
  const Soup& soup_;
  TangleLimits limits_;
  /// #faces and #vertices: 1 for those of places that are refilled already.
  std::vector<std::uint8_t> is_refilled_;
  std::vector<std::uint8_t> is_of_refilled_;
  /// #faces: 1 for those of places.
  std::vector<std::uint8_t> is_taken_;
  /// The vertices, united where they belong to one place.
  DisjointSets joined_;
  std::vector<std::vector<Index>> places_;
};

}  // namespace

Tangles find_tangles(const PreparedMesh& mesh, const TangleLimits& limits,
                     std::span<const Index> refilled) {
  return TangleSearch(mesh, limits, refilled).run();
}

}  // namespace meshalyzer
