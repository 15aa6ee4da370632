#include "meshalyzer/set/spatial_order.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace meshalyzer {
namespace {

constexpr unsigned kBits = 21;

/// Every third bit of the result is one of the lowest 21 of `x`.
std::uint64_t spread(std::uint64_t x) {
  std::uint64_t spread = 0;
  for (unsigned bit = 0; bit < kBits; ++bit) {
    spread |= (x >> bit & 1U) << (3 * bit);
  }
  return spread;
}

Box3 box_of(std::span<const Box3> boxes) {
  Box3 all;
  for (const Box3& box : boxes) {
    all.extend(box);
  }
  return all;
}

/// Halves before the sum: it may overflow where the coordinates do not.
Vec3 middle(const Box3& box) {
  return box.min() / 2 + box.max() / 2;
}

std::uint64_t morton_code(const Vec3& point, const Box3& all) {
  const Vec3 half = all.max() / 2 - all.min() / 2;
  const Vec3 offset = point / 2 - all.min() / 2;
  std::uint64_t code = 0;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double t = half[k] > 0.0 ? std::clamp(offset[k] / half[k], 0.0, 1.0) : 0.0;
    code |= spread(static_cast<std::uint64_t>(t * ((1U << kBits) - 1))) << k;
  }
  return code;
}

/// The axis along which the boxes are narrowest beside all of them together.
Eigen::Index best_axis(std::span<const Box3> boxes) {
  const Box3 all = box_of(boxes);
  const Vec3 half = all.max() / 2 - all.min() / 2;
  Vec3 total = Vec3::Zero();
  for (const Box3& box : boxes) {
    if (!box.isEmpty()) {
      for (Eigen::Index k = 0; k < 3; ++k) {
        total[k] += half[k] > 0.0 ? (box.max()[k] / 2 - box.min()[k] / 2) / half[k] : 1.0;
      }
    }
  }
  Eigen::Index best = 0;
  total.minCoeff(&best);
  return best;
}

}  // namespace

std::vector<Index> order_in_space(std::span<const Box3> boxes) {
  const Box3 all = box_of(boxes);
  std::vector<std::pair<std::uint64_t, Index>> keys;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].isEmpty()) {
      keys.emplace_back(morton_code(middle(boxes[i]), all), static_cast<Index>(i));
    }
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Index> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(),
                 [](const auto& key) { return key.second; });
  return order;
}

std::vector<std::vector<Index>> find_meeting_boxes(std::span<const Box3> boxes) {
  const Eigen::Index axis = best_axis(boxes);
  std::vector<Index> by_low;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].isEmpty()) {
      by_low.push_back(static_cast<Index>(i));
    }
  }
  std::sort(by_low.begin(), by_low.end(), [&](Index a, Index b) {
    return std::pair(boxes[a].min()[axis], a) < std::pair(boxes[b].min()[axis], b);
  });
  std::vector<std::vector<Index>> meeting(boxes.size());
  for (std::size_t i = 0; i < by_low.size(); ++i) {
    const Box3& box = boxes[by_low[i]];
    for (std::size_t j = i + 1;
         j < by_low.size() && boxes[by_low[j]].min()[axis] <= box.max()[axis]; ++j) {
      if (box.intersects(boxes[by_low[j]])) {
        meeting[by_low[i]].push_back(by_low[j]);
        meeting[by_low[j]].push_back(by_low[i]);
      }
    }
  }
  for (std::vector<Index>& others : meeting) {
    std::sort(others.begin(), others.end());
  }
  return meeting;
}

double distance(const Box3& a, const Box3& b) {
  const Vec3 gap = (a.min() - b.max()).cwiseMax(b.min() - a.max()).cwiseMax(Vec3::Zero());
  // Neither overflow nor underflow may make a gap of what is none, or none of what is one.
  return gap.stableNorm();
}

}  // namespace meshalyzer
