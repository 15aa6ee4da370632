#include "meshalyzer/spatial/fan_tree.h"

#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>

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

bool names(const Triangle& t, Index v) {
  return t[0] == v || t[1] == v || t[2] == v;
}

/// Returns the fan of the faces of one leaf.
Fan fan_of_leaf(const FaceTree& tree, std::size_t begin, std::size_t end) {
  Fan fan;
  for (const Index candidate : tree.triangle(begin)) {
    std::size_t slot = begin + 1;
    while (slot < end && names(tree.triangle(slot), candidate)) {
      ++slot;
    }
    if (slot == end) {
      fan.hub = candidate;
      break;
    }
  }
  if (fan.hub == kNoIndex) {
    return fan;
  }
  fan.rim = kEmpty;
  for (std::size_t slot = begin; slot < end; ++slot) {
    for (const Index v : tree.triangle(slot)) {
      if (v != fan.hub) {
        const auto p = tree.map(tree.point(v));
        extend(fan.rim, {p, p});
      }
    }
  }
  return fan;
}

Fan fan_of_node(std::span<const Fan> children) {
  Fan fan = children.front();
  for (const Fan& child : children.subspan(1)) {
    if (child.hub != fan.hub) {
      return {};
    }
    extend(fan.rim, child.rim);
  }
  return fan;
}

}  // namespace

FanTree::FanTree(const FaceTree& tree) {
  levels_.emplace_back(tree.n_leaves());
  parallel_chunks(tree.n_leaves(), 1024, [&](Chunk chunk) {
    for (std::size_t leaf = chunk.begin; leaf < chunk.end; ++leaf) {
      levels_.front()[leaf] = fan_of_leaf(tree, 8 * leaf, std::min(8 * (leaf + 1), tree.n_faces()));
    }
  });
  while (levels_.size() < tree.n_levels()) {
    const std::vector<Fan>& below = levels_.back();
    std::vector<Fan> level((below.size() + 7) / 8);
    for (std::size_t i = 0; i < level.size(); ++i) {
      level[i] = fan_of_node(
          std::span(below).subspan(8 * i, std::min<std::size_t>(8, below.size() - 8 * i)));
    }
    levels_.push_back(std::move(level));
  }
}

bool FanTree::meet_at_hub_only(const Fan& a, const TreeBox& box_a, const Fan& b,
                               const TreeBox& box_b) {
  return a.hub != kNoIndex && a.hub == b.hub && are_apart(a.rim, box_b) && are_apart(b.rim, box_a);
}

}  // namespace meshalyzer
