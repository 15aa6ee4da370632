#include "meshalyzer/picture/internal/neighbourhoods.h"

#include "meshalyzer/base/items_by_group.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns those of some faces that are at each vertex, in the order given.
ItemsByGroup faces_by_vertex(const Soup& soup, std::span<const Index> faces) {
  return ItemsByGroup(soup.n_vertices(), [&](const auto& use) {
    for (const Index f : faces) {
      for (const Index v : soup.triangles[f]) use(v, f);
    }
  });
}

/// A breadth-first walk that visits each face and each vertex once.
class Walk {
 public:
  Walk(const Soup& soup, std::size_t max_faces)
      : soup_(soup),
        max_faces_(max_faces),
        has_face_(soup.n_faces(), 0),
        has_vertex_(soup.n_vertices(), 0) {}

  [[nodiscard]] bool is_full() const { return taken_.size() >= max_faces_; }

  void take_face(Index face) {
    if (is_full() || has_face_[face] != 0) return;
    has_face_[face] = 1;
    taken_.push_back(face);
    for (const Index v : soup_.triangles[face]) take_vertex(v);
  }

  void take_vertex(Index vertex) {
    if (has_vertex_[vertex] != 0) return;
    has_vertex_[vertex] = 1;
    queue_.push_back(vertex);
  }

  /// Continues from the vertices in the order in which they were visited, so that faces come ring
  /// by ring.
  void go_on(const ItemsByGroup& faces) {
    for (std::size_t i = 0; i < queue_.size() && !is_full(); ++i) {
      for (const Index f : faces[queue_[i]]) take_face(f);
    }
  }

  [[nodiscard]] std::vector<Index> taken_in_order() {
    std::sort(taken_.begin(), taken_.end());
    return std::move(taken_);
  }

 private:
  const Soup& soup_;
  std::size_t max_faces_;
  std::vector<std::uint8_t> has_face_;
  std::vector<std::uint8_t> has_vertex_;
  std::vector<Index> taken_;
  std::vector<Index> queue_;
};

}  // namespace

std::vector<Index> faces_round(const Soup& soup, std::span<const Index> drawable,
                               const Seeds& seeds, std::size_t max_faces) {
  if (seeds.faces.empty() && seeds.vertices.empty()) return {};
  Walk walk(soup, max_faces);
  for (const Index f : seeds.faces) walk.take_face(f);
  for (const Index v : seeds.vertices) walk.take_vertex(v);
  walk.go_on(faces_by_vertex(soup, drawable));
  return walk.taken_in_order();
}

}  // namespace meshalyzer
