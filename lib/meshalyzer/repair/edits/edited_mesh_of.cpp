#include "meshalyzer/repair/edits/edited_mesh_of.h"

#include "meshalyzer/base/disjoint_sets.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace meshalyzer {
namespace {

using Relation = ElementOrigin::Relation;

ElementOrigin origin_of_vertex(const TrackedMesh& tracked, Index key) {
  if (key < tracked.n_input_vertices) return {Relation::Same, key};
  const Index origin = tracked.vertex_origins[key - tracked.n_input_vertices];
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

  /// Returns the input's face that the neighbour of a patch is or was made of; kNoIndex where there
  /// is none.
  [[nodiscard]] Index record_beside(Index face) {
    const auto place = std::lower_bound(faces_.begin(), faces_.end(), face) - faces_.begin();
    return neighbours_[patches_.find(static_cast<Index>(place))];
  }

 private:
  static std::uint64_t edge(const Triangle& t, std::size_t k) {
    const Index a = t[k];
    const Index b = t[(k + 1) % 3];
    return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
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
  /// Which of them are joined through edges, by their places in that list.
  DisjointSets patches_;
  /// A face of a patch at each edge that one has.
  std::unordered_map<std::uint64_t, Index> edges_;
  /// By the lowest place of a patch.
  std::vector<Index> neighbours_;
};

}  // namespace

EditedMesh edited_mesh_of(const TrackedMesh& tracked, const Soup& input) {
  EditedMesh mesh{input, tracked.soup, {}, {}};
  mesh.vertices.reserve(tracked.vertex_keys.size());
  for (const Index key : tracked.vertex_keys) {
    mesh.vertices.push_back(origin_of_vertex(tracked, key));
  }
  PatchNeighbours patches(tracked);
  mesh.faces.reserve(tracked.face_keys.size());
  for (std::size_t f = 0; f < tracked.face_keys.size(); ++f) {
    const auto face = static_cast<Index>(f);
    const Index key = tracked.face_keys[f];
    const Index origin = tracked.origin_of_face(face);
    if (key < tracked.n_input_faces) {
      mesh.faces.push_back({Relation::Same, key});
    } else if (origin != kNoIndex) {
      mesh.faces.push_back({Relation::MadeOf, origin});
    } else {
      mesh.faces.push_back({Relation::Beside, patches.record_beside(face)});
    }
  }
  return mesh;
}

}  // namespace meshalyzer
