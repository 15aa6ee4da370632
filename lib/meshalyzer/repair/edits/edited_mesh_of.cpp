#include "meshalyzer/repair/edits/edited_mesh_of.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/mesh/edge_key.h"
#include "meshalyzer/mesh/vertex_faces.h"
#include "meshalyzer/spatial/triangle_distance.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace meshalyzer {
namespace {

using Relation = ElementOrigin::Relation;

ElementOrigin origin_of_vertex(const TrackedMesh& tracked, Index key) {
  const Index origin = tracked.origin_of_vertex_key(key);
  if (origin == key) return {Relation::Same, key};
  return {origin == kNoIndex ? Relation::New : Relation::MadeOf, origin};
}

/// Finds for each hole patch the first face that shares an edge with it.
class PatchNeighbours {
 public:
  explicit PatchNeighbours(const TrackedMesh& tracked) : tracked_(tracked), patches_(0) {
    for (std::size_t f = 0; f < tracked.face_keys.size(); ++f) {
      const auto face = static_cast<Index>(f);
      if (tracked.origin_of_face(face) == kNoIndex) faces_.push_back(face);
    }
    if (faces_.empty()) return;
    patches_ = DisjointSets(faces_.size());
    join_patches();
    find_neighbours();
  }

  /// Returns the input's face that the neighbour of a patch is or was made of; kNoIndex if there is
  /// none.
  [[nodiscard]] Index record_beside(Index face) {
    const auto place = std::lower_bound(faces_.begin(), faces_.end(), face) - faces_.begin();
    return neighbours_[patches_.find(static_cast<Index>(place))];
  }

 private:
  static std::uint64_t edge(const Triangle& t, std::size_t k) {
    return edge_key(t[k], t[(k + 1) % 3]);
  }

  void join_patches() {
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint64_t key = edge(tracked_.soup.triangles[faces_[i]], k);
        const auto [entry, is_new] = edges_.emplace(key, static_cast<Index>(i));
        if (!is_new) patches_.unite(entry->second, static_cast<Index>(i));
      }
    }
  }

  void find_neighbours() {
    neighbours_.assign(faces_.size(), kNoIndex);
    for (std::size_t f = 0; f < tracked_.soup.n_faces(); ++f) {
      const Index origin = tracked_.origin_of_face(static_cast<Index>(f));
      for (std::size_t k = 0; k < 3 && origin != kNoIndex; ++k) {
        const auto found = edges_.find(edge(tracked_.soup.triangles[f], k));
        if (found == edges_.end()) continue;
        Index& neighbour = neighbours_[patches_.find(found->second)];
        if (neighbour == kNoIndex) neighbour = origin;
      }
    }
  }

  const TrackedMesh& tracked_;
  /// The faces of all patches, ascending.
  std::vector<Index> faces_;
  /// The sets of these faces that are joined through edges, by their indices in that list.
  DisjointSets patches_;
  /// A face of a patch at each edge of a patch.
  std::unordered_map<std::uint64_t, Index> edges_;
  /// The face beside each patch, by the lowest place of the patch.
  std::vector<Index> neighbours_;
};

/// Finds the face of the input that a changed face lies on.
///
/// A flipped edge leaves two faces, each with one corner beyond its old face, and may leave a face
/// that lies on the neighbour alone: a cap has no area to keep.
class FacesBelow {
 public:
  FacesBelow(const TrackedMesh& tracked, const Soup& input) : tracked_(tracked), input_(input) {}

  /// @param origin  The face of the input that the face is or was made of; it is the answer where
  ///                the format has no attributes of faces.
  [[nodiscard]] Index find(Index face, Index origin) {
    if (input_.format == Format::Mesh) return origin;
    const Triangle& before = input_.triangles[origin];
    Index below = origin;
    for (const Index v : tracked_.soup.triangles[face]) {
      const Index key = v == kNoIndex ? kNoIndex : tracked_.vertex_keys[v];
      if (key >= tracked_.n_input_vertices || contains(before, key) || !has_all_corners(before)) {
        continue;
      }
      if (!faces_) faces_ = std::make_unique<VertexFaces>(input_);
      for_each_face_beside(input_, *faces_, before, key, [&](Index other) {
        if (is_nearer(face, other, below)) below = other;
      });
    }
    return below;
  }

 private:
  static bool contains(const Triangle& triangle, Index vertex) {
    return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end();
  }

  /// Tells whether the middle of a face is nearer to one face of the input than to another, beyond
  /// rounding.
  [[nodiscard]] bool is_nearer(Index face, Index candidate, Index other) const {
    if (!has_all_corners(input_.triangles[candidate])) return false;
    const Corners corners = corners_of(tracked_.soup, face);
    const Vec3 middle = centroid_of(corners);
    constexpr double kBeyondRounding = 1e-9;
    const double slack = kBeyondRounding * (corners[1] - corners[0]).norm();
    return closest_on_triangle(corners_of(input_, candidate), middle).distance + slack <
           closest_on_triangle(corners_of(input_, other), middle).distance;
  }

  const TrackedMesh& tracked_;
  const Soup& input_;
  /// The faces of the input by their vertices; found when they are first needed.
  std::unique_ptr<VertexFaces> faces_;
};

}  // namespace

EditedMesh edited_mesh_of(const TrackedMesh& tracked, const Soup& input) {
  EditedMesh mesh{input, tracked.soup, {}, {}};
  mesh.vertices.reserve(tracked.vertex_keys.size());
  for (const Index key : tracked.vertex_keys) {
    mesh.vertices.push_back(origin_of_vertex(tracked, key));
  }
  PatchNeighbours patches(tracked);
  FacesBelow faces_below(tracked, input);
  mesh.faces.reserve(tracked.face_keys.size());
  for (std::size_t f = 0; f < tracked.face_keys.size(); ++f) {
    const auto face = static_cast<Index>(f);
    const Index key = tracked.face_keys[f];
    const Index origin = tracked.origin_of_face(face);
    if (origin != kNoIndex) {
      const Index below = faces_below.find(face, origin);
      if (below != origin) mesh.left_places.push_back(origin);
      mesh.faces.push_back({below == key ? Relation::Same : Relation::MadeOf, below});
    } else {
      mesh.faces.push_back({Relation::Beside, patches.record_beside(face)});
    }
  }
  return mesh;
}

}  // namespace meshalyzer
