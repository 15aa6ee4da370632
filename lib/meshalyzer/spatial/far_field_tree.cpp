#include "meshalyzer/spatial/far_field_tree.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/spatial/order_by_size.h"
#include "meshalyzer/spatial/shares_of_directions.h"
#include "meshalyzer/spatial/tree_width.h"

#include <algorithm>

namespace meshalyzer {
namespace {

/// The shares of directions of all triangles of a tree, as seen from two points.
class Shares {
 public:
  Shares(const std::vector<std::vector<FarField>>& levels, const std::vector<Corners>& triangles,
         const TwoVectors& points, double near)
      : levels_(levels), triangles_(triangles), points_(points), near_(near) {}

  [[nodiscard]] Two total() {
    Two sum = Two::Zero();
    for (std::size_t i = 0; i < levels_.back().size(); ++i) sum += far(levels_.size() - 1, i);
    return sum + near_triangles_.total();
  }

 private:
  /// Returns the shares of what is far below a node, and adds the triangles that are not.
  Two far(std::size_t level, std::size_t i) {
    const FarField& field = levels_[level][i];
    const TwoVectors to_centre = points_.from(field.centre);
    const Two distance_squared = to_centre.dot(to_centre);
    if (distance_squared.minCoeff() > field.far_squared) {
      return field.share_from(to_centre, distance_squared);
    }
    const std::size_t n_below = level == 0 ? triangles_.size() : levels_[level - 1].size();
    const std::size_t end = std::min(kTreeWidth * (i + 1), n_below);
    Two sum = Two::Zero();
    for (std::size_t child = kTreeWidth * i; child < end; ++child) {
      if (level == 0) {
        near_triangles_.add(triangles_[child], points_, near_);
      } else {
        sum += far(level - 1, child);
      }
    }
    return sum;
  }

  const std::vector<std::vector<FarField>>& levels_;
  const std::vector<Corners>& triangles_;
  const TwoVectors& points_;
  double near_;
  SharesOfDirections near_triangles_;
};

}  // namespace

FarFieldTree::FarFieldTree(std::span<const Corners> triangles, double near, double far)
    : near_(near), far_(far) {
  triangles_.reserve(triangles.size());
  for (const Index i : order_by_size(triangles)) triangles_.push_back(triangles[i]);
  for (std::size_t length = kTreeWidth; !triangles_.empty(); length *= kTreeWidth) {
    levels_.push_back(level_of(length));
    if (levels_.back().size() <= kTreeWidth) {
      break;
    }
  }
}

std::vector<FarField> FarFieldTree::level_of(std::size_t length) const {
  std::vector<FarField> level(n_chunks(triangles_.size(), length));
  const std::size_t nodes_per_task = std::max<std::size_t>(1, kChunkLength / length);
  parallel_chunks(level.size(), nodes_per_task, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const std::size_t end = std::min(length * (i + 1), triangles_.size());
      level[i] = far_field_of(std::span(triangles_).subspan(length * i, end - length * i), far_);
    }
  });
  return level;
}

Two FarFieldTree::at(const TwoVectors& points) const {
  if (levels_.empty()) return Two::Zero();
  return Shares(levels_, triangles_, points, near_).total();
}

}  // namespace meshalyzer
