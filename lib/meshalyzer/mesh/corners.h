#pragma once

#include "meshalyzer/base/types.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

// The data types of build(), private to the mesh module.
//
// Corner 3 k + i is corner i of face k of the complex. It also names the side that begins at it:
// the directed edge from the vertex of this corner to that of the next one.

[[nodiscard]] constexpr Index next_corner(Index corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

[[nodiscard]] constexpr Index previous_corner(Index corner) {
  return corner % 3 == 0 ? corner + 2 : corner - 1;
}

/// The faces of a soup that are in its complex.
struct Complex {
  std::size_t n_vertices = 0;
  /// All triangles of the soup.
  std::span<const Triangle> triangles;
  /// The faces of the complex, ascending: face k of the complex is triangle faces[k].
  std::span<const Index> faces;

  [[nodiscard]] std::size_t n_corners() const { return 3 * faces.size(); }
  [[nodiscard]] const Triangle& triangle(std::size_t face) const { return triangles[faces[face]]; }
  [[nodiscard]] Index vertex(Index corner) const { return triangle(corner / 3)[corner % 3]; }
};

/// Several lists of corners in one array.
struct CornerLists {
  /// #lists + 1: where each list begins in `corners`.
  std::vector<Index> begin{0};
  std::vector<Index> corners;

  [[nodiscard]] std::size_t size() const { return begin.size() - 1; }
  [[nodiscard]] std::span<const Index> operator[](std::size_t i) const {
    return std::span(corners).subspan(begin[i], begin[i + 1] - begin[i]);
  }
  void push_back(Index corner) { corners.push_back(corner); }
  /// Ends the list that push_back() has filled.
  void end_list() { begin.push_back(static_cast<Index>(corners.size())); }
  void append(const CornerLists& other) {
    const Index shift = begin.back();
    for (std::size_t i = 1; i < other.begin.size(); ++i) begin.push_back(other.begin[i] + shift);
    corners.insert(corners.end(), other.corners.begin(), other.corners.end());
  }
};

}  // namespace meshalyzer
