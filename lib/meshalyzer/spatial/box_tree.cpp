#include "meshalyzer/spatial/box_tree.h"

#include "meshalyzer/base/box.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/spatial/finite_part.h"
#include "meshalyzer/spatial/tree_width.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace meshalyzer {
namespace {

constexpr unsigned kBits = 21;

/// Spreads the lowest 21 bits of `x` to every third bit of the result: halves of what is still
/// together are moved apart, step by step.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32U) & 0x001F00000000FFFFU;
  x = (x | x << 16U) & 0x001F0000FF0000FFU;
  x = (x | x << 8U) & 0x100F00F00F00F00FU;
  x = (x | x << 4U) & 0x10C30C30C30C30C3U;
  return (x | x << 2U) & 0x1249249249249249U;
}

Box3 box_round(std::span<const Box3> boxes) {
  Box3 all;
  for (const Box3& box : boxes) {
    all.extend(box);
  }
  return all;
}

std::uint64_t morton_code(const Box3& box, const Box3& all) {
  const Vec3 half_width = half_widths_of(all);
  const Vec3 offset = middle_of(box) / 2 - all.min() / 2;
  std::uint64_t code = 0;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double t = half_width[k] > 0.0 ? std::clamp(offset[k] / half_width[k], 0.0, 1.0) : 0.0;
    code |= spread(static_cast<std::uint64_t>(t * ((1U << kBits) - 1))) << k;
  }
  return code;
}

}  // namespace

std::vector<Index> order_in_space(std::span<const Box3> boxes) {
  const Box3 all = finite_part(box_round(boxes));
  auto keys = collect_chunks<std::pair<std::uint64_t, Index>>(
      boxes.size(), [&](Chunk chunk, std::vector<std::pair<std::uint64_t, Index>>& found) {
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
          if (boxes[i].isEmpty()) continue;
          found.emplace_back(morton_code(finite_part(boxes[i]), all), static_cast<Index>(i));
        }
      });
  std::sort(keys.begin(), keys.end());
  std::vector<Index> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(),
                 [](const auto& key) { return key.second; });
  return order;
}

BoxTree::BoxTree(std::span<const Box3> boxes) : order_(order_in_space(boxes)), levels_(1) {
  for (const Index i : order_) {
    levels_.front().push_back(boxes[i]);
  }
  while (levels_.back().size() > kTreeWidth) {
    const std::span<const Box3> below = levels_.back();
    std::vector<Box3> level;
    for (std::size_t i = 0; i < below.size(); i += kTreeWidth) {
      level.push_back(box_round(below.subspan(i, std::min(kTreeWidth, below.size() - i))));
    }
    levels_.push_back(std::move(level));
  }
}

std::vector<Index> BoxTree::meeting(const Box3& box) const {
  std::vector<Index> found;
  for (std::size_t i = 0; i < levels_.back().size(); ++i) {
    collect(levels_.size() - 1, i, box, found);
  }
  std::sort(found.begin(), found.end());
  return found;
}

bool BoxTree::meets_any(const Box3& box) const {
  for (std::size_t i = 0; i < levels_.back().size(); ++i) {
    if (meets_below(levels_.size() - 1, i, box)) return true;
  }
  return false;
}

bool BoxTree::meets_below(std::size_t level, std::size_t i, const Box3& box) const {
  if (!levels_[level][i].intersects(box)) return false;
  if (level == 0) return true;
  const std::size_t end = std::min(kTreeWidth * (i + 1), levels_[level - 1].size());
  for (std::size_t child = kTreeWidth * i; child < end; ++child) {
    if (meets_below(level - 1, child, box)) return true;
  }
  return false;
}

void BoxTree::collect(std::size_t level, std::size_t i, const Box3& box,
                      std::vector<Index>& found) const {
  if (!levels_[level][i].intersects(box)) {
    return;
  }
  if (level == 0) {
    found.push_back(order_[i]);
    return;
  }
  const std::size_t end = std::min(kTreeWidth * (i + 1), levels_[level - 1].size());
  for (std::size_t child = kTreeWidth * i; child < end; ++child) {
    collect(level - 1, child, box, found);
  }
}

}  // namespace meshalyzer
