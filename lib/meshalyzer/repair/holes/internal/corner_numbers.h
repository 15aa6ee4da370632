#pragma once

#include "meshalyzer/base/types.h"

#include <unordered_map>
#include <vector>

namespace meshalyzer {

/// The corners of a loop by their vertices; of several at one vertex, the first one. Triangles by
/// corners mean the same on a mesh whose vertices have other numbers.
class CornerNumbers {
 public:
  /// @param vertices  Those of the loop, by corner.
  explicit CornerNumbers(const std::vector<Index>& vertices) {
    for (Index i = 0; i < vertices.size(); ++i) number_of_.emplace(vertices[i], i);
  }

  /// @return  kNoIndex for other vertices.
  [[nodiscard]] Index of(Index vertex) const {
    const auto found = number_of_.find(vertex);
    return found == number_of_.end() ? kNoIndex : found->second;
  }
  [[nodiscard]] Triangle of(const Triangle& t) const { return {of(t[0]), of(t[1]), of(t[2])}; }
  [[nodiscard]] std::vector<Triangle> of(std::vector<Triangle> triangles) const {
    for (Triangle& t : triangles) t = of(t);
    return triangles;
  }

 private:
  std::unordered_map<Index, Index> number_of_;
};

/// Returns triangles that are given by the corners of a loop by its vertices.
[[nodiscard]] inline std::vector<Triangle> at_vertices(std::vector<Triangle> triangles,
                                                       const std::vector<Index>& vertices) {
  for (Triangle& t : triangles) t = {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
  return triangles;
}

}  // namespace meshalyzer
