#include "meshalyzer/spatial/fan_tree.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/spatial/tree_width.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace meshalyzer {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr TreeBox kEmpty{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};

void extend(TreeBox& box, const TreeBox& by) {
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = std::min(box.low[k], by.low[k]);
    box.high[k] = std::max(box.high[k], by.high[k]);
  }
}

bool are_apart(const TreeBox& a, const TreeBox& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.high[k] < b.low[k] || b.high[k] < a.low[k]) {
      return true;
    }
  }
  return false;
}

/// Returns the vertex that all faces of a leaf have in common, or kNoIndex. A leaf with far faces
/// has none, because its rim would be in another place.
Index hub_of_leaf(const FaceTree& tree, std::size_t leaf) {
  if (tree.is_far_leaf(leaf)) return kNoIndex;
  const std::size_t begin = 8 * leaf;
  const std::size_t end = std::min(begin + 8, tree.n_faces());
  for (const Index candidate : tree.triangle(begin)) {
    std::size_t slot = begin + 1;
    while (slot < end && has_corner(tree.triangle(slot), candidate)) ++slot;
    if (slot == end) return candidate;
  }
  return kNoIndex;
}

/// @param hub  The vertex that all faces of the leaf have in common.
Fan fan_of_leaf(const FaceTree& tree, std::size_t leaf, Index hub) {
  Fan fan{hub, kEmpty};
  const std::size_t end = std::min(8 * (leaf + 1), tree.n_faces());
  for (std::size_t slot = 8 * leaf; slot < end; ++slot) {
    for (const Index v : tree.triangle(slot)) {
      if (v == hub) continue;
      extend(fan.rim, tree.box_of_vertex(v));
    }
  }
  return fan;
}

}  // namespace

FanTree::FanTree(const FaceTree& tree) {
  add_leaves(tree);
  while (levels_.size() < tree.n_levels()) add_level();
}

void FanTree::add_leaves(const FaceTree& tree) {
  levels_.emplace_back(tree.n_leaves(), Index{0});
  const std::vector<Index> leaves = parallel_filter(
      tree.n_leaves(), [&](Index leaf) { return hub_of_leaf(tree, leaf) != kNoIndex; });
  for (const Index leaf : leaves) {
    levels_.front()[leaf] = static_cast<Index>(fans_.size());
    fans_.push_back(fan_of_leaf(tree, leaf, hub_of_leaf(tree, leaf)));
  }
}

void FanTree::add_level() {
  const std::vector<Index>& below = levels_.back();
  std::vector<Index> level(n_chunks(below.size(), kTreeWidth), 0);
  for (std::size_t i = 0; i < level.size(); ++i) {
    const auto children =
        std::span(below).subspan(8 * i, std::min<std::size_t>(8, below.size() - 8 * i));
    Fan fan = fans_[children.front()];
    const bool is_fan = fan.hub != kNoIndex &&
                        std::all_of(children.begin(), children.end(),
                                    [&](Index child) { return fans_[child].hub == fan.hub; });
    if (!is_fan) continue;
    for (const Index child : children) extend(fan.rim, fans_[child].rim);
    level[i] = static_cast<Index>(fans_.size());
    fans_.push_back(fan);
  }
  levels_.push_back(std::move(level));
}

bool FanTree::meet_at_hub_only(const Fan& a, const TreeBox& box_a, const Fan& b,
                               const TreeBox& box_b) {
  return a.hub != kNoIndex && a.hub == b.hub && are_apart(a.rim, box_b) && are_apart(b.rim, box_a);
}

}  // namespace meshalyzer
