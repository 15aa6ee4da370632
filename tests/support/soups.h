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

}  // namespace meshalyzer
