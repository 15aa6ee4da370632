#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
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

}  // namespace meshalyzer
