#include "meshalyzer/repair/holes/internal/patch_edges.h"

#include <algorithm>
#include <cstddef>

namespace meshalyzer {

PatchEdges::PatchEdges(const Patch& patch) {
  edges_.reserve(3 * patch.triangles.size());
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    const Triangle& t = patch.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      edges_.push_back({{t[k], t[(k + 1) % 3]}, static_cast<Index>(i)});
    }
  }
  std::sort(edges_.begin(), edges_.end());
}

Index PatchEdges::face_at(const std::array<Index, 2>& ends) const {
  const auto at = std::lower_bound(edges_.begin(), edges_.end(), DirectedEdge{ends});
  return at != edges_.end() && at->ends == ends ? at->face : kNoIndex;
}

}  // namespace meshalyzer
