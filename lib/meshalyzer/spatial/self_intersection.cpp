#include "meshalyzer/spatial/self_intersection.h"

#include "meshalyzer/spatial/proven_stars.h"
#include "meshalyzer/spatial/self_intersection_search.h"

#include <cstdint>

namespace meshalyzer {

std::vector<IntersectingPair> find_self_intersections(const CutMesh& cut, const FaceTree& tree,
                                                      std::size_t max_pairs) {
  if (tree.n_faces() == 0) {
    return {};
  }
  const SlabTree slabs(tree);
  const FanTree fans(tree);
  const std::vector<std::uint8_t> proven = prove_stars(cut);
  return search_self_intersections({.cut = cut,
                                    .tree = tree,
                                    .slabs = slabs,
                                    .fans = fans,
                                    .proven = proven,
                                    .max_pairs = max_pairs});
}

}  // namespace meshalyzer
