#include "meshalyzer/repair/cut/internal/face_edges.h"

#include <algorithm>
#include <cstddef>

namespace meshalyzer {

std::vector<FaceEdge> sorted_edges(std::span<const Triangle> faces) {
  std::vector<FaceEdge> edges;
  edges.reserve(3 * faces.size());
  for (Index face = 0; face < faces.size(); ++face) {
    const Triangle& t = faces[face];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      edges.push_back({{low, high}, face, low == t[k] ? 1 : -1});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const FaceEdge& a, const FaceEdge& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.face < b.face;
  });
  return edges;
}

}  // namespace meshalyzer
