#include "meshalyzer/repair/cut/internal/unfinished_parts.h"

#include "meshalyzer/base/disjoint_sets.h"

namespace meshalyzer {

std::vector<std::uint8_t> which_are_of_unfinished_parts(const CutSurface& surface,
                                                        std::size_t n_faces) {
  DisjointSets parts(n_faces);
  for (const auto& [a, b] : surface.ties) {
    if (a < n_faces && b < n_faces) parts.unite(a, b);
  }
  std::vector<std::uint8_t> found(n_faces, 0);
  for (const Index face : surface.unfinished) {
    if (face < n_faces) found[parts.find(face)] = 1;
  }
  for (Index face = 0; face < n_faces; ++face) found[face] = found[parts.find(face)];
  return found;
}

}  // namespace meshalyzer
