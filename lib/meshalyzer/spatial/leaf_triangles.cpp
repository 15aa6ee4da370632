#include "meshalyzer/spatial/leaf_triangles.h"

#include <algorithm>
#include <limits>

namespace meshalyzer {

LeafTriangles::LeafTriangles(const FaceTree& tree, std::size_t leaf) {
  const std::size_t last = tree.n_faces() - 1;
  for (std::size_t i = 0; i < 8; ++i) {
    const Triangle t = tree.triangle(std::min(8 * leaf + i, last));
    const bool is_far = tree.is_far_leaf(leaf) && std::any_of(t.begin(), t.end(), [&](Index v) {
                          return tree.is_far(tree.placed(v));
                        });
    for (std::size_t c = 0; c < 3; ++c) {
      const std::array<float, 3> p = tree.map(tree.placed(t[c]));
      for (std::size_t k = 0; k < 3; ++k) {
        corners[c][k][i] = is_far ? std::numeric_limits<float>::quiet_NaN() : p[k];
      }
    }
  }
}

}  // namespace meshalyzer
