#include "meshalyzer/spatial/self_intersection.h"

#include "meshalyzer/spatial/corner_angles.h"
#include "meshalyzer/spatial/long_face_tree.h"
#include "meshalyzer/spatial/pair_collector.h"
#include "meshalyzer/spatial/proven_stars.h"
#include "meshalyzer/spatial/self_intersection_search.h"
#include "meshalyzer/spatial/shared_vertices.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

namespace meshalyzer {
namespace {

/// Passes all pairs on to one listener or two.
class TwoListeners : public PairListener {
 public:
  /// @param second  May be null.
  TwoListeners(PairListener& first, PairListener* second) : first_(first), second_(second) {}

  void on_pairs(std::span<const IntersectingPair> pairs) override {
    first_.on_pairs(pairs);
    if (second_ != nullptr) second_->on_pairs(pairs);
  }
  void on_product(const PairProduct& product) override {
    first_.on_product(product);
    if (second_ != nullptr) second_->on_product(product);
  }

 private:
  PairListener& first_;
  PairListener* second_;
};

}  // namespace

std::vector<IntersectingPair> find_self_intersections(const CutMesh& cut, const FaceTree& tree) {
  return find_self_intersections(cut, tree, PairLimits{}).listed;
}

FoundPairs find_self_intersections(const CutMesh& cut, const FaceTree& tree,
                                   const PairLimits& limits, PairListener* also) {
  PairCollector collector(std::min(limits.max_listed, limits.max_found));
  TwoListeners both(collector, also);
  const bool is_complete = visit_self_intersections(cut, tree, limits, both);
  FoundPairs found = collector.take();
  found.is_complete = is_complete;
  return found;
}

bool visit_self_intersections(const CutMesh& cut, const FaceTree& tree, const PairLimits& limits,
                              PairListener& listener) {
  if (tree.n_faces() == 0) return true;
  const std::optional<FaceTree> turned = turned_for_long_faces(tree);
  const FaceTree& searched = turned ? *turned : tree;
  const SlabTree slabs(searched);
  const FanTree fans(searched);
  const std::vector<std::uint8_t> proven = prove_stars(cut);
  const CornerAngles angles(searched, proven);
  const FaceGroups groups(cut, searched);
  // Only of bundles so many leaves are compared with each other that this pays.
  std::optional<SharedVertices> shared;
  if (slabs.has_useful()) shared.emplace(searched, angles);
  return search_self_intersections({.cut = cut,
                                    .tree = searched,
                                    .slabs = slabs,
                                    .fans = fans,
                                    .proven = proven,
                                    .angles = angles.empty() ? nullptr : &angles,
                                    .shared = shared ? &*shared : nullptr,
                                    .groups = groups.size() == 0 ? nullptr : &groups},
                                   limits, listener);
}

}  // namespace meshalyzer
