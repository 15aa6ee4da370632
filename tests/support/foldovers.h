#pragma once

#include "support/shapes.h"

#include <cstddef>
#include <utility>

namespace meshalyzer::shapes {

/// Returns the number of vertex (x, y) of grid(nx, ny).
[[nodiscard]] inline Index grid_vertex(std::size_t nx, std::size_t x, std::size_t y) {
  return static_cast<Index>(y * (nx + 1) + x);
}

/// Returns a flat sheet with one vertex dragged over one edge of its ring: one face is turned over,
/// and lies on the face beyond that edge. `height` lifts the vertex off the plane.
///
/// grid(5, 4) with the vertex (2, 2) moved to (3.1, 2.5). Its ring is (3,2), (3,3), (2,3), (1,2),
/// (1,1), (2,1); the edge it passes is (3,2)-(3,3), and the place is on the left of the five
/// others, so that no other face turns.
[[nodiscard]] inline Soup dragged_vertex(double height = 0.0) {
  Soup soup = grid(5, 4);
  soup.positions[grid_vertex(5, 2, 2)] = {3.1, 2.5, height};
  return soup;
}

/// Returns a sheet of nx x 2 squares folded over along the lines x = folds[0], folds[1], ... so
/// that it runs to and fro in its plane.
template <typename Folds>
[[nodiscard]] Soup folded_strip(std::size_t nx, const Folds& folds) {
  Soup soup = grid(nx, 2);
  for (Vec3& p : soup.positions) {
    double x = 0.0;
    double at = 0.0;
    double direction = 1.0;
    for (const double fold : folds) {
      if (p[0] <= fold) break;
      x += direction * (fold - at);
      at = fold;
      direction = -direction;
    }
    p[0] = x + direction * (p[0] - at);
  }
  return soup;
}

/// Returns a sheet with one corner folded over: grid(5, 4) with the vertex (5, 0), which has one
/// face, moved inside over the edge (4,0)-(5,1).
[[nodiscard]] inline Soup dog_ear() {
  Soup soup = grid(5, 4);
  soup.positions[grid_vertex(5, 5, 0)] = {4.4, 0.6, 0.0};
  return soup;
}

}  // namespace meshalyzer::shapes
