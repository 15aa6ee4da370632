#include "meshalyzer/prepared/prepared_mesh.h"

#include "meshalyzer/spatial/self_intersection.h"

#include <utility>

namespace meshalyzer {

const std::vector<IntersectingPair>& PreparedMesh::intersecting_pairs() const {
  std::call_once(pairs_known_, [this] { pairs_ = find_self_intersections(cut_, tree_); });
  return pairs_;
}

void PreparedMesh::know_intersecting_pairs(std::vector<IntersectingPair> pairs) {
  std::call_once(pairs_known_, [&] { pairs_ = std::move(pairs); });
}

}  // namespace meshalyzer
