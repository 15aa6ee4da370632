#include "meshalyzer/spatial/closest_point.h"

#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace meshalyzer {
namespace {

// Lower bounds of distances are computed in the tree's coordinates, in single precision. They must
// not exceed the distance that closest_on_triangle() computes by more than a slack. With u = 2^-24
// and the true distance d, both in the tree's coordinates:
//
// - A coordinate of a box or corner is at most 1, so it is off by 1.01 u; one of the query is at
//   most 1 + d, so it is off by u (1 + d): a corner as seen from the query by sqrt(3) (2.01 + d) u,
//   and by u of its distance for the subtraction.
// - That distance is at most d + sqrt(12), the diagonal of the tree's bounds. The product with a
//   direction adds 3 u of it.
// - Squares, sums, quotient and the length of the direction add less than 8 u d.
// - What closest_on_triangle() computes is off by some 2^-53 (d + 4): nothing beside u.
//
// The sum is at most 18 u + 14 u d, so these constants are generous:
constexpr double kAbsoluteSlack = 0x1p-18;
constexpr double kRelativeSlack = 0x1p-19;
/// Coordinates of the query are clamped to this, so that fourth powers do not overflow. Clamping
/// never takes it farther from any face, because it projects onto a box that contains them all.
constexpr double kFarthest = 0x1p30;

/// One number for each child of a node, as vector registers hold them.
using Eight = Eigen::Array<float, 8, 1>;

Eight squared_distances(const EightBoxes& boxes, const std::array<float, 3>& from) {
  Eight squared = Eight::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Map<const Eight, Eigen::Aligned16> low(boxes.min[k].data());
    const Eigen::Map<const Eight, Eigen::Aligned16> high(boxes.max[k].data());
    squared += (low - from[k]).max(from[k] - high).max(0.0F).square();
  }
  return squared;
}

/// Returns lower bounds of the squared distances of eight triangles.
///
/// Along any direction no point of a triangle is nearer than its nearest corner; the direction to
/// the centroid is a good and cheap choice.
Eight squared_distances(const EightTriangles& triangles, const std::array<float, 3>& from) {
  std::array<std::array<Eight, 3>, 3> corner;
  std::array<Eight, 3> middle;
  Eight length = Eight::Constant(std::numeric_limits<float>::min());
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      corner[i][k] =
          Eigen::Map<const Eight, Eigen::Aligned16>(triangles.corners[i][k].data()) - from[k];
    }
    middle[k] = corner[0][k] + corner[1][k] + corner[2][k];
    length += middle[k].square();
  }
  const auto along = [&](std::size_t i) -> Eight {
    return corner[i][0] * middle[0] + corner[i][1] * middle[1] + corner[i][2] * middle[2];
  };
  return along(0).min(along(1)).min(along(2)).max(0.0F).square() / length;
}

/// Returns a mask in which bit i is set if number i is at most `limit`.
unsigned within(const Eight& numbers, float limit) {
  unsigned bits = 0;
  for (unsigned i = 0; i < 8; ++i) {
    bits |= static_cast<unsigned>(numbers[i] <= limit) << i;
  }
  return bits;
}

/// A face (level 0), or a node of the tree's level `level` - 1, that remains to be searched.
struct Entry {
  /// A lower bound of its squared distance.
  float squared;
  std::uint32_t level;
  Index index;
};

/// The entries that remain to be searched, with the nearest of a node's children on top.
class Stack {
 public:
  [[nodiscard]] bool empty() const { return size_ == 0; }
  Entry pop() { return entries_[--size_]; }

  /// Adds an entry under those with index `bottom` and above that are nearer.
  void insert(std::size_t bottom, const Entry& entry) {
    std::size_t i = size_++;
    for (; i > bottom && entries_[i - 1].squared < entry.squared; --i) {
      entries_[i] = entries_[i - 1];
    }
    entries_[i] = entry;
  }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  /// A tree of 2^32 faces has 11 levels of nodes; each leaves at most 7 entries when the eighth is
  /// popped.
  std::array<Entry, 96> entries_;
  std::size_t size_ = 0;
};

/// One query while it descends the tree.
class Search {
 public:
  Search(const FaceTree& tree, std::span<const EightTriangles> triangles, const ClosestQuery& query)
      : tree_(tree),
        triangles_(triangles),
        query_(query),
        place_((query.point - tree.centre()) * tree.scale()) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      clamped_[static_cast<std::size_t>(k)] =
          static_cast<float>(std::clamp(place_[k], -kFarthest, kFarthest));
    }
    best_.distance = query.within;
    set_reach();
  }

  std::optional<SurfacePoint> run() {
    if (tree_.n_faces() == 0) {
      return std::nullopt;
    }
    if (query_.hint < tree_.n_faces()) {
      consider(query_.hint);
    }
    stack_.insert(0, {0.0F, static_cast<std::uint32_t>(tree_.n_levels()), 0});
    while (!stack_.empty()) {
      const Entry entry = stack_.pop();
      if (entry.squared > reach_) {
        continue;
      }
      if (entry.level == 0) {
        consider(entry.index);
      } else if (entry.level == 1) {
        open_leaf(entry.index);
      } else {
        open_node(entry);
      }
    }
    return best_.mesh_face == kNoIndex ? std::nullopt : std::optional(best_);
  }

 private:
  /// Pushes the children of a node that may hold the answer.
  void open_node(const Entry& entry) {
    const EightBoxes& node = tree_.node(entry.level - 1, entry.index);
    const Eight squared = squared_distances(node, clamped_);
    const std::size_t bottom = stack_.size();
    for (unsigned bits = within(squared, reach_); bits != 0; bits &= bits - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(bits));
      if (!(query_.cone && is_outside(*query_.cone, node.box(i)))) {
        stack_.insert(bottom, {squared[i], entry.level - 1, 8 * entry.index + i});
      }
    }
  }

  /// Pushes the faces of a leaf that may hold the answer; their corners cull more than their boxes
  /// would.
  void open_leaf(Index leaf) {
    const Eight squared = squared_distances(triangles_[leaf], clamped_);
    const std::size_t bottom = stack_.size();
    for (unsigned bits = within(squared, reach_); bits != 0; bits &= bits - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(bits));
      stack_.insert(bottom, {squared[i], 0, 8 * leaf + i});
    }
  }

  void consider(Index slot) {
    const Index face = tree_.mesh_face(slot);
    if (!query_.excluded.empty() && query_.excluded[face] != 0) {
      return;
    }
    if (query_.is_wanted != nullptr && !(*query_.is_wanted)(face)) {
      return;
    }
    const Triangle& t = tree_.triangle(slot);
    const Corners corners{tree_.point(t[0]), tree_.point(t[1]), tree_.point(t[2])};
    const std::optional<TrianglePoint> found =
        query_.cone ? closest_on_triangle(corners, query_.point, *query_.cone)
                    : closest_on_triangle(corners, query_.point);
    if (found && (found->distance < best_.distance ||
                  (found->distance == best_.distance && face < best_.mesh_face))) {
      best_ = {found->point, found->distance, face, slot};
      set_reach();
    }
  }

  /// Tells whether a plane along the side of the cone separates the cone from the box.
  [[nodiscard]] bool is_outside(const Cone& cone, const TreeBox& box) const {
    Vec3 middle;
    Vec3 half;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto low = static_cast<double>(box.low[k]);
      const auto high = static_cast<double>(box.high[k]);
      middle[static_cast<Eigen::Index>(k)] = (low + high) / 2;
      half[static_cast<Eigen::Index>(k)] = (high - low) / 2;
    }
    const Vec3 to_middle = middle - place_;
    const double along = to_middle.dot(cone.axis);
    const Vec3 across = to_middle - along * cone.axis;
    const double length = across.norm();
    if (length == 0.0) {
      return false;
    }
    const double sine = std::sqrt(1.0 - cone.cos_half_angle * cone.cos_half_angle);
    const Vec3 outward = (cone.cos_half_angle / length) * across - sine * cone.axis;
    // A point that closest_on_triangle() finds in the cone may be outside by the square root of the
    // double precision where an edge grazes the cone; the side of a box by that of single
    // precision.
    return to_middle.dot(outward) - half.dot(outward.cwiseAbs()) >
           kAbsoluteSlack + kRelativeSlack * to_middle.norm();
  }

  /// Boxes with a larger squared distance hold nothing that would replace the best so far.
  void set_reach() {
    const bool is_on_face = best_.distance == 0.0 && best_.mesh_face != kNoIndex;
    if (is_on_face && query_.choice == FaceChoice::AnyAtPoint) {
      reach_ = -1.0F;
      return;
    }
    const double reach = best_.distance * tree_.scale() * (1 + kRelativeSlack) + kAbsoluteSlack;
    // Empty boxes lie at infinity and are never within reach.
    reach_ = static_cast<float>(
        std::min(reach * reach, static_cast<double>(std::numeric_limits<float>::max())));
  }

  const FaceTree& tree_;
  std::span<const EightTriangles> triangles_;
  const ClosestQuery& query_;
  /// The point of the query in the tree's coordinates.
  Vec3 place_;
  std::array<float, 3> clamped_{};
  SurfacePoint best_;
  float reach_ = 0.0F;
  Stack stack_;
};

}  // namespace

EightTriangles EightTriangles::none() {
  EightTriangles triangles;
  for (auto& corner : triangles.corners) {
    for (auto& coordinates : corner) {
      coordinates.fill(std::numeric_limits<float>::quiet_NaN());
    }
  }
  return triangles;
}

ClosestPoints::ClosestPoints(const FaceTree& tree)
    : tree_(tree), triangles_(tree.n_leaves(), EightTriangles::none()) {
  parallel_chunks(tree.n_faces(), [&](Chunk chunk) {
    for (std::size_t slot = chunk.begin; slot < chunk.end; ++slot) {
      EightTriangles& leaf = triangles_[slot / 8];
      for (std::size_t i = 0; i < 3; ++i) {
        const std::array<float, 3> corner = tree.map(tree.point(tree.triangle(slot)[i]));
        for (std::size_t k = 0; k < 3; ++k) {
          leaf.corners[i][k][slot % 8] = corner[k];
        }
      }
    }
  });
}

std::optional<SurfacePoint> ClosestPoints::find(const ClosestQuery& query) const {
  return Search(tree_, triangles_, query).run();
}

}  // namespace meshalyzer
