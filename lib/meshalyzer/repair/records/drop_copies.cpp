#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/rules/internal/drop_unmissed_faces.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Decides which components are copies.
class CopySearch {
 public:
  explicit CopySearch(const PreparedMesh& mesh) : soup_(mesh.soup()) {
    for (const IntersectingPair& pair : mesh.intersecting_pairs()) {
      if (pair.kind != ContactKind::CoplanarOverlap) continue;
      if (!have_equal_corners(soup_, pair.face_a, pair.face_b)) continue;
      twins_.push_back({pair.face_a, pair.face_b});
      twins_.push_back({pair.face_b, pair.face_a});
    }
    if (twins_.empty()) return;
    std::sort(twins_.begin(), twins_.end());
    const Components components = find_edge_components(mesh.cut());
    component_of_ = components_of_file_faces(mesh.cut(), components, soup_.n_faces());
    faces_.resize(components.count);
    for (Index face = 0; face < soup_.n_faces(); ++face) {
      if (component_of_[face] != kNoIndex) faces_[component_of_[face]].push_back(face);
    }
    is_copy_.assign(components.count, 0);
  }

  /// Returns the faces of each copy.
  [[nodiscard]] std::vector<std::vector<Index>> run() {
    std::vector<std::vector<Index>> copies;
    for (const Index component : smallest_first()) {
      if (!is_covered(component)) continue;
      is_copy_[component] = 1;
      copies.push_back(std::move(faces_[component]));
    }
    return copies;
  }

 private:
  /// Returns the components; of those with the same number of faces the last one comes first.
  [[nodiscard]] std::vector<Index> smallest_first() const {
    std::vector<Index> order(faces_.size());
    std::iota(order.rbegin(), order.rend(), Index{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return faces_[a].size() < faces_[b].size(); });
    return order;
  }

  /// Tells whether each face of a component coincides with one of the same other component, which
  /// stays. If the faces of several do, as the walls of its neighbours, it is a part of its own.
  [[nodiscard]] bool is_covered(Index component) const {
    const std::vector<Index>& faces = faces_[component];
    return any_twin(faces.front(), [&](Index first_twin) {
      const Index other = component_of_[first_twin];
      const auto is_twin_there = [&](Index twin) { return component_of_[twin] == other; };
      return other != component && is_copy_[other] == 0 &&
             std::all_of(faces.begin(), faces.end(),
                         [&](Index face) { return any_twin(face, is_twin_there); });
    });
  }

  /// Tells whether a predicate is true of any of the faces that coincide with a face.
  template <typename Predicate>
  [[nodiscard]] bool any_twin(Index face, const Predicate& predicate) const {
    auto twin = std::lower_bound(twins_.begin(), twins_.end(), std::array{face, Index{0}});
    for (; twin != twins_.end() && (*twin)[0] == face; ++twin) {
      if (predicate((*twin)[1])) return true;
    }
    return false;
  }

  const Soup& soup_;
  /// Each face with each that coincides with it, ascending.
  std::vector<std::array<Index, 2>> twins_;
  std::vector<Index> component_of_;
  std::vector<std::vector<Index>> faces_;
  /// #components: 1 for those that are dropped.
  std::vector<std::uint8_t> is_copy_;
};

}  // namespace

PassResult drop_copies(const PassInput& input) {
  // The faces that they coincide with stay.
  return drop_unmissed_faces(input, CopySearch(input.mesh).run(), DefectCode::SelfIntersection);
}

}  // namespace meshalyzer
