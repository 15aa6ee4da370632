#include "meshalyzer/spatial/self_intersection.h"

#include "meshalyzer/spatial/corner_angles.h"
#include "meshalyzer/spatial/pair_collector.h"
#include "meshalyzer/spatial/proven_stars.h"
#include "meshalyzer/spatial/self_intersection_search.h"
#include "meshalyzer/spatial/shared_vertices.h"

#include <cstdint>
#include <optional>

namespace meshalyzer {

std::vector<IntersectingPair> find_self_intersections(const CutMesh& cut, const FaceTree& tree,
                                                      std::size_t max_pairs) {
  PairCollector collector(max_pairs);
  visit_self_intersections(cut, tree, {.max_found = max_pairs, .wants_to_stop = {}}, collector);
  return collector.take().listed;
}

bool visit_self_intersections(const CutMesh& cut, const FaceTree& tree, const PairLimits& limits,
                              PairListener& listener) {
  if (tree.n_faces() == 0) return true;
  const SlabTree slabs(tree);
  const FanTree fans(tree);
  const std::vector<std::uint8_t> proven = prove_stars(cut);
  const CornerAngles angles(tree, proven);
  const FaceGroups groups(cut, tree);
  // Only of bundles so many leaves are compared with each other that this pays.
  std::optional<SharedVertices> shared;
  if (slabs.has_useful()) shared.emplace(tree, angles);
  return search_self_intersections({.cut = cut,
                                    .tree = tree,
                                    .slabs = slabs,
                                    .fans = fans,
                                    .proven = proven,
                                    .angles = angles.empty() ? nullptr : &angles,
                                    .shared = shared ? &*shared : nullptr,
                                    .groups = groups.size() == 0 ? nullptr : &groups},
                                   limits, listener);
}

}  // namespace meshalyzer
