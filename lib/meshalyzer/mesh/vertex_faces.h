#pragma once

#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/mesh/soup.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace meshalyzer {

/// The faces of a soup by the vertices that they name.
class VertexFaces {
 public:
  /// @complexity O(#V + #F).
  explicit VertexFaces(const Soup& soup)
      : by_vertex_(soup.n_vertices(), [&](const auto& use) {
          for (std::size_t f = 0; f < soup.n_faces(); ++f) {
            for (const Index vertex : soup.triangles[f]) {
              if (vertex != kNoIndex) use(vertex, static_cast<Index>(f));
            }
          }
        }) {}

  /// Returns the faces at a vertex, ascending; a face occurs once for each of its corners at the
  /// vertex.
  [[nodiscard]] std::span<const Index> at(Index vertex) const { return by_vertex_[vertex]; }

 private:
  ItemsByGroup by_vertex_;
};

/// Calls `use` with the faces of a soup that name `vertex` and at least two vertices of `triangle`;
/// with some of them twice.
///
/// @complexity O(the faces at the vertex, or at two corners of the triangle, whichever are fewer).
template <typename Use>
void for_each_face_beside(const Soup& soup, const VertexFaces& faces, const Triangle& triangle,
                          Index vertex, Use use) {
  const auto names = [](const Triangle& t, Index v) { return t[0] == v || t[1] == v || t[2] == v; };
  const auto use_those_of = [&](Index at) {
    for (const Index face : faces.at(at)) {
      const Triangle& t = soup.triangles[face];
      const auto n_shared = std::count_if(triangle.begin(), triangle.end(),
                                          [&](Index corner) { return names(t, corner); });
      if (names(t, vertex) && n_shared >= 2) {
        use(face);
      }
    }
  };
  Triangle corners = triangle;
  std::sort(corners.begin(), corners.end(),
            [&](Index a, Index b) { return faces.at(a).size() < faces.at(b).size(); });
  if (faces.at(vertex).size() <= faces.at(corners[1]).size()) {
    use_those_of(vertex);
  } else {
    use_those_of(corners[0]);
    use_those_of(corners[1]);
  }
}

}  // namespace meshalyzer
