#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace meshalyzer {

/// Returns a soup of these faces over n vertices on a curve without three collinear ones, for tests
/// of connectivity only.
[[nodiscard]] inline Soup soup_of(std::size_t n_vertices, std::vector<Triangle> triangles) {
  Soup soup;
  for (std::size_t i = 0; i < n_vertices; ++i) {
    const auto x = static_cast<double>(i);
    soup.positions.emplace_back(x, x * x, x * x * x);
  }
  soup.triangles = std::move(triangles);
  return soup;
}

/// Returns four faces in a half circle round vertex 0, counter-clockwise: 1 is the first vertex of
/// the rim, 5 the last.
[[nodiscard]] inline Soup half_disc() {
  return soup_of(6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}});
}

/// Returns faces round an edge that all of them have in common, and go through in the same
/// direction.
[[nodiscard]] inline Soup faces_round_edge(Index n_faces) {
  Soup soup;
  soup.positions = {{0, 0, 0}, {0, 0, 1}};
  for (Index i = 0; i < n_faces; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n_faces;
    soup.positions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    soup.triangles.push_back({0, 1, 2 + i});
  }
  return soup;
}

}  // namespace meshalyzer
