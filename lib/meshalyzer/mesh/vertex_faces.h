#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// The faces of a soup by the vertices that they name.
class VertexFaces {
 public:
  /// @complexity O(#V + #F).
  explicit VertexFaces(const Soup& soup)
      : begins_(soup.n_vertices() + 2, 0), faces_(3 * soup.n_faces()) {
    const auto for_each_corner = [&](auto use) {
      for (std::size_t f = 0; f < soup.n_faces(); ++f) {
        for (const Index vertex : soup.triangles[f]) {
          if (vertex != kNoIndex) {
            use(vertex, static_cast<Index>(f));
          }
        }
      }
    };
    for_each_corner([&](Index vertex, Index) { ++begins_[vertex + 2]; });
    for (std::size_t v = 2; v < begins_.size(); ++v) {
      begins_[v] += begins_[v - 1];
    }
    for_each_corner([&](Index vertex, Index face) { faces_[begins_[vertex + 1]++] = face; });
  }

  /// Ascending; a face stands there once for each of its corners at the vertex.
  [[nodiscard]] std::span<const Index> at(Index vertex) const {
    return std::span(faces_).subspan(begins_[vertex], begins_[vertex + 1] - begins_[vertex]);
  }

 private:
  /// By vertex: where its faces begin.
  std::vector<Index> begins_;
  std::vector<Index> faces_;
};

/// How many corners of a triangle name a vertex that another one names too.
[[nodiscard]] inline std::size_t count_shared(const Triangle& a, const Triangle& b) {
  std::size_t n = 0;
  for (const Index vertex : a) {
    n += vertex == b[0] || vertex == b[1] || vertex == b[2] ? 1 : 0;
  }
  return n;
}

}  // namespace meshalyzer
