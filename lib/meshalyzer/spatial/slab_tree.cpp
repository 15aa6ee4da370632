#include "meshalyzer/spatial/slab_tree.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/spatial/eight_reaches.h"
#include "meshalyzer/spatial/long_face.h"
#include "meshalyzer/spatial/tree_width.h"

#include <algorithm>
#include <span>
#include <utility>

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
  const auto p = tree.map(tree.placed(v));
  return {p[0], p[1], p[2]};
}

bool has_long_face(const FaceTree& tree, std::size_t leaf) {
  const std::size_t end = std::min(8 * (leaf + 1), tree.n_faces());
  for (std::size_t slot = 8 * leaf; slot < end; ++slot) {
    if (is_long_face(tree.corners(slot))) return true;
  }
  return false;
}

/// Returns the corners of all faces below FaceTree::node(level, i), one after the other; none if
/// one of the faces is far, because its corners would be in another place.
std::vector<Vec3f> corners_of(const FaceTree& tree, std::size_t level, std::size_t i) {
  const std::size_t faces_per_node = std::size_t{8} << (3 * level);
  const std::size_t begin = i * faces_per_node;
  const std::size_t end = std::min(begin + faces_per_node, tree.n_faces());
  std::vector<Vec3f> corners;
  corners.reserve(3 * (end - begin));
  for (std::size_t slot = begin; slot < end; ++slot) {
    if (slot % 8 == 0 && tree.is_far_leaf(slot / 8)) return {};
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
  return lengths_squared > kLong * areas ? Vec3f(sum.normalized()) : Vec3f::Zero();
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
  if (corners.empty()) return slabs;
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

bool Slabs::exclude(const LeafTriangles& faces) const {
  const EightCorners corners = loaded(faces);
  for (std::size_t a = 0; a < 2; ++a) {
    const EightReaches reaches(eight_times(axis[a]), corners);
    if ((EightFloats::all(high[a]) < reaches.low).bits() == 0xFFU ||
        (reaches.high < EightFloats::all(low[a])).bits() == 0xFFU) {
      return true;
    }
  }
  return false;
}

SlabTree::SlabTree(const FaceTree& tree) {
  // A bundle consists of bundles: where no leaf is one, no node is.
  const std::vector<Index> bundles = parallel_filter(tree.n_leaves(), [&](Index leaf) {
    return has_long_face(tree, leaf) && make_slabs(corners_of(tree, 0, leaf)).is_useful;
  });
  if (bundles.empty()) return;
  while (levels_.size() < tree.n_levels()) add_level(tree);
  keep_triangles(tree);
}

void SlabTree::keep_triangles(const FaceTree& tree) {
  triangles_.resize(tree.n_leaves());
  parallel_chunks(triangles_.size(), kNodesPerChunk, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) triangles_[i] = LeafTriangles(tree, i);
  });
}

void SlabTree::add_level(const FaceTree& tree) {
  const std::size_t number = levels_.size();
  const std::vector<Slabs> none;
  const std::vector<Slabs>& below = number == 0 ? none : levels_.back();
  const auto may_be_useful = [&](std::size_t i) {
    const auto children =
        std::span(below).subspan(8 * i, std::min<std::size_t>(8, below.size() - 8 * i));
    return std::any_of(children.begin(), children.end(),
                       [](const Slabs& s) { return s.is_useful; });
  };
  std::vector<Slabs> level(number == 0 ? tree.n_leaves() : n_chunks(below.size(), kTreeWidth));
  parallel_chunks(level.size(), kNodesPerChunk, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      if (number == 0 || may_be_useful(i)) level[i] = make_slabs(corners_of(tree, number, i));
    }
  });
  levels_.push_back(std::move(level));
}

}  // namespace meshalyzer
