#include "meshalyzer/spatial/slab_tree.h"

#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <span>

namespace meshalyzer {
namespace {

/// The number of nodes that one task makes: those of as many faces as other tasks have.
constexpr std::size_t kNodesPerChunk = kChunkLength / 8;

using Vec3f = Eigen::Vector3f;

/// A bundle is worth slabs when it is this many times thinner, along both, than its box is wide.
constexpr float kThin = 8.0F;
/// Coordinates are within 1.5 of 0 and off by less than 2^-23; sums of three products by less than
/// 2^-20.
constexpr float kSlack = 0x1p-19F;

Vec3f mapped(const FaceTree& tree, Index v) {
  const auto p = tree.map(tree.point(v));
  return {p[0], p[1], p[2]};
}

/// Returns the corners of a range of slots, one after the other.
std::vector<Vec3f> corners_of(const FaceTree& tree, std::size_t begin, std::size_t end) {
  std::vector<Vec3f> corners;
  corners.reserve(3 * (end - begin));
  for (std::size_t slot = begin; slot < end; ++slot) {
    for (const Index v : tree.triangle(slot)) {
      corners.push_back(mapped(tree, v));
    }
  }
  return corners;
}

/// Returns the way the longest edges of the faces run on the whole; zero where the faces are not
/// long and thin.
Vec3f common_direction(std::span<const Vec3f> corners) {
  Vec3f sum = Vec3f::Zero();
  float lengths_squared = 0.0F;
  float areas = 0.0F;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const std::array<Vec3f, 3> edges{corners[i + 1] - corners[i], corners[i + 2] - corners[i + 1],
                                     corners[i] - corners[i + 2]};
    const Vec3f& longest = *std::max_element(
        edges.begin(), edges.end(),
        [](const Vec3f& a, const Vec3f& b) { return a.squaredNorm() < b.squaredNorm(); });
    lengths_squared += longest.squaredNorm();
    areas += edges[0].cross(edges[1]).norm();
    sum += sum.dot(longest) < 0.0F ? Vec3f(-longest) : longest;
  }
  return lengths_squared > kThin * areas ? Vec3f(sum.normalized()) : Vec3f::Zero();
}

/// Returns the mean normal of the faces, made perpendicular to `along`.
Vec3f common_normal(std::span<const Vec3f> corners, const Vec3f& along) {
  Vec3f sum = Vec3f::Zero();
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const Vec3f normal = (corners[i + 1] - corners[i]).cross(corners[i + 2] - corners[i]);
    sum += sum.dot(normal) < 0.0F ? Vec3f(-normal) : normal;
  }
  const Vec3f across = sum - sum.dot(along) * along;
  return across.norm() > 1e-3F * sum.norm() ? across.normalized() : along.unitOrthogonal();
}

float width_of_box(std::span<const Vec3f> corners) {
  Vec3f low = corners.front();
  Vec3f high = low;
  for (const Vec3f& p : corners) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).minCoeff();
}

Slabs make_slabs(std::span<const Vec3f> corners) {
  Slabs slabs;
  const Vec3f along = common_direction(corners);
  if (along.isZero()) {
    return slabs;
  }
  const float width = width_of_box(corners);
  const Vec3f normal = common_normal(corners, along);
  const std::array<Vec3f, 2> axes{normal, along.cross(normal)};
  slabs.is_useful = true;
  for (std::size_t a = 0; a < 2; ++a) {
    slabs.axis[a] = {axes[a].x(), axes[a].y(), axes[a].z()};
    const auto [low, high] = std::minmax_element(
        corners.begin(), corners.end(),
        [&](const Vec3f& p, const Vec3f& q) { return axes[a].dot(p) < axes[a].dot(q); });
    slabs.low[a] = axes[a].dot(*low) - kSlack;
    slabs.high[a] = axes[a].dot(*high) + kSlack;
    slabs.is_useful = slabs.is_useful && kThin * (slabs.high[a] - slabs.low[a]) < width;
  }
  return slabs;
}

}  // namespace

LeafCorners::LeafCorners(const FaceTree& tree, std::size_t leaf) {
  const std::size_t last = tree.n_faces() - 1;
  for (std::size_t i = 0; i < 8; ++i) {
    const Triangle& t = tree.triangle(std::min(8 * leaf + i, last));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto p = tree.map(tree.point(t[k]));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        coordinates[axis][3 * i + k] = p[axis];
      }
    }
  }
}

bool Slabs::exclude(const LeafCorners& corners) const {
  for (std::size_t a = 0; a < 2; ++a) {
    std::array<float, LeafCorners::kCorners> along;
    for (std::size_t i = 0; i < along.size(); ++i) {
      along[i] = axis[a][0] * corners.coordinates[0][i] + axis[a][1] * corners.coordinates[1][i] +
                 axis[a][2] * corners.coordinates[2][i];
    }
    const auto [lowest, highest] = std::minmax_element(along.begin(), along.end());
    if (*lowest > high[a] || *highest < low[a]) {
      return true;
    }
  }
  return false;
}

SlabTree::SlabTree(const FaceTree& tree) {
  std::size_t faces_per_node = 8;
  std::size_t nodes = tree.n_leaves();
  for (std::size_t level = 0; level < tree.n_levels(); ++level) {
    levels_.emplace_back(nodes);
    parallel_chunks(nodes, kNodesPerChunk, [&](Chunk chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        const std::size_t end = std::min((i + 1) * faces_per_node, tree.n_faces());
        // A bundle consists of bundles: if no child is one, neither is the parent, and the faces
        // need no further test.
        const auto children_begin = level == 0 ? nullptr : levels_[level - 1].data() + 8 * i;
        const auto children_end = level == 0 ? nullptr
                                             : levels_[level - 1].data() +
                                                   std::min(8 * (i + 1), levels_[level - 1].size());
        const bool may_be_useful =
            level == 0 ||
            std::any_of(children_begin, children_end, [](const Slabs& s) { return s.is_useful; });
        if (may_be_useful && i * faces_per_node < end) {
          levels_[level][i] = make_slabs(corners_of(tree, i * faces_per_node, end));
          if (levels_[level][i].is_useful) {
            has_useful_.store(true, std::memory_order_relaxed);
          }
        }
      }
    });
    faces_per_node *= 8;
    nodes = (nodes + 7) / 8;
  }
}

}  // namespace meshalyzer
