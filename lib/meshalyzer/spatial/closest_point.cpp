#include "meshalyzer/spatial/closest_point.h"

#include "meshalyzer/base/eight_lanes.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/spatial/eight_reaches.h"
#include "meshalyzer/spatial/oriented_boxes.h"
#include "meshalyzer/spatial/tree_width.h"

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
// - The place of the query along a direction of an oriented box is off by less than 7 u (1 + d),
//   and three of these together by sqrt(3) times that. Their directions add 2 u d (see
//   squared_distances()), the bounds of such a box nothing, as they allow for their own errors.
// - Squares, sums, quotient and the length of the direction add less than 8 u d.
// - What closest_on_triangle() computes is off by some 2^-53 (d + 4): nothing beside u.
//
// The sum is at most 18 u + 23 u d, so these constants are generous:
constexpr double kAbsoluteSlack = 0x1p-18;
constexpr double kRelativeSlack = 0x1p-19;
// With far faces coordinates are at most 2, which doubles the first three at most.
/// Coordinates of the query are clamped to this, so that fourth powers do not overflow. Clamping
/// never takes it farther from any face, because it projects onto a box that contains them all.
constexpr float kFarthest = 0x1p30F;

/// A squared distance in double precision times this is below the exact one: differences, squares
/// and sums add less than 8 roundings.
constexpr double kBelowRounding = 1.0 - 0x1p-49;

/// Returns the squared distances of eight boxes from another one.
EightFloats squared_distances(const EightBoxes& boxes, const TreeBox& from) {
  const EightFloats zero = EightFloats::all(0.0F);
  EightFloats squared = zero;
  for (std::size_t k = 0; k < 3; ++k) {
    const EightFloats below = EightFloats::load(boxes.min[k]) - EightFloats::all(from.high[k]);
    const EightFloats above = EightFloats::all(from.low[k]) - EightFloats::load(boxes.max[k]);
    const EightFloats gap = max(max(below, above), zero);
    squared = squared + gap * gap;
  }
  return squared;
}

/// Returns the corners of eight triangles relative to a point.
EightCorners seen_from(const std::array<float, 3>& from, const EightTriangles& triangles) {
  EightCorners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const EightFloats at = EightFloats::all(from[k]);
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i][k] = EightFloats::load(triangles.corners[i][k]) - at;
    }
  }
  return corners;
}

/// Returns lower bounds of the squared distances of eight triangles from the origin, each from a
/// direction: along any direction no point of a triangle is nearer than its nearest corner. The
/// closer the direction is to that of the closest point, the better the bound.
EightFloats squared_distances(const EightCorners& corners, const EightVectors& direction) {
  const EightFloats along =
      min(min(dot_product(corners[0], direction), dot_product(corners[1], direction)),
          dot_product(corners[2], direction));
  const EightFloats ahead = max(along, EightFloats::all(0.0F));
  const EightFloats length =
      dot_product(direction, direction) + EightFloats::all(std::numeric_limits<float>::min());
  return ahead * ahead / length;
}

/// Returns directions from the origin to eight triangles, which are cheap to compute: those to the
/// centroids.
EightVectors rough_direction(const EightCorners& corners) {
  EightVectors direction;
  for (std::size_t k = 0; k < 3; ++k) {
    direction[k] = corners[0][k] + corners[1][k] + corners[2][k];
  }
  return direction;
}

EightVectors select(const EightFlags& flags, const EightVectors& a, const EightVectors& b) {
  return {select(flags, a[0], b[0]), select(flags, a[1], b[1]), select(flags, a[2], b[2])};
}

/// Returns the points of eight triangles that are closest to the origin, up to rounding; where
/// rounding matters much, as in slivers, any point.
EightVectors fine_direction(const EightCorners& corners) {
  const EightFloats zero = EightFloats::all(0.0F);
  const EightFloats one = EightFloats::all(1.0F);
  const EightFloats tiny = EightFloats::all(std::numeric_limits<float>::min());
  EightCorners side;
  EightVectors best = corners[0];
  EightFloats squared = dot_product(best, best);
  for (std::size_t i = 0; i < 3; ++i) {
    const EightVectors& from = corners[i];
    side[i] = subtracted(corners[(i + 1) % 3], from);
    const EightFloats foot =
        (zero - dot_product(from, side[i])) / max(dot_product(side[i], side[i]), tiny);
    const EightFloats at = min(max(foot, zero), one);
    const EightVectors point{from[0] + at * side[i][0], from[1] + at * side[i][1],
                             from[2] + at * side[i][2]};
    const EightFloats of_point = dot_product(point, point);
    best = select(of_point < squared, point, best);
    squared = min(of_point, squared);
  }
  const EightVectors normal = cross_product(side[0], side[1]);
  const EightFloats height =
      dot_product(normal, corners[0]) / max(dot_product(normal, normal), tiny);
  const auto is_within_side = [&](std::size_t i) {
    return zero < dot_product(normal, cross_product(corners[i], corners[(i + 1) % 3]));
  };
  const EightFlags is_inside = is_within_side(0) & is_within_side(1) & is_within_side(2);
  return select(is_inside, EightVectors{height * normal[0], height * normal[1], height * normal[2]},
                best);
}

/// Returns the squared distance in the tree's coordinates beyond which nothing is within a distance
/// in the mesh's unit.
float squared_reach(const FaceTree& tree, double distance) {
  const double reach = distance * tree.scale() * (1 + kRelativeSlack) + kAbsoluteSlack;
  // Empty boxes lie at infinity and are never within reach.
  return static_cast<float>(
      std::min(reach * reach, static_cast<double>(std::numeric_limits<float>::max())));
}

/// Tells whether a leaf below a node is within reach of a box.
bool has_leaf_near(const FaceTree& tree, std::size_t level, std::size_t i, const TreeBox& box,
                   float reach) {
  unsigned near = (squared_distances(tree.node(level, i), box) <= EightFloats::all(reach)).bits();
  if (level <= 1) return near != 0;
  for (; near != 0; near &= near - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(near));
    if (has_leaf_near(tree, level - 1, 8 * i + lane, box, reach)) return true;
  }
  return false;
}

/// The number of nodes with eight leaves each that one task bounds: those of as many faces as other
/// tasks have.
constexpr std::size_t kNodesOfLeavesPerChunk = kChunkLength / (kTreeWidth * kTreeWidth);

/// A node of the tree that remains to be searched.
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
  Search(const FaceTree& tree, std::span<const EightTriangles> triangles,
         std::span<const EightOrientedBoxes> leaf_boxes, const ClosestQuery& query)
      : tree_(tree),
        triangles_(triangles),
        leaf_boxes_(leaf_boxes),
        query_(query),
        place_((query.point - tree.centre()) * tree.scale()),
        clamped_(tree.map_within(query.point, kFarthest)) {
    best_.distance = query.within;
    set_reach();
  }

  std::optional<SurfacePoint> run() {
    if (tree_.n_faces() == 0 || !query_.point.allFinite()) {
      return std::nullopt;
    }
    if (query_.hint < tree_.n_faces()) {
      consider(query_.hint);
    }
    stack_.insert(0, {0.0F, static_cast<std::uint32_t>(tree_.n_levels() - 1), 0});
    while (!stack_.empty()) {
      const Entry entry = stack_.pop();
      if (entry.squared > reach_) {
        continue;
      }
      if (entry.level == 0) {
        open_leaf(entry.index);
      } else {
        open_node(entry);
      }
    }
    return best_.mesh_face == kNoIndex ? std::nullopt : std::optional(best_);
  }

 private:
  /// Pushes the children of a node that may hold the answer, or opens them if they are leaves.
  void open_node(const Entry& entry) {
    const EightBoxes& node = tree_.node(entry.level, entry.index);
    const EightFloats squared = squared_distances(node, TreeBox{clamped_, clamped_});
    unsigned near = within_reach(squared);
    if (query_.cone) {
      near = those_in_cone(*query_.cone, node, near);
    }
    if (entry.level == 1) {
      open_near_leaves(entry.index, squared, near);
      return;
    }
    const std::array<float, 8> numbers = squared.numbers();
    const std::size_t bottom = stack_.size();
    for (; near != 0; near &= near - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(near));
      stack_.insert(bottom, {numbers[i], entry.level - 1, 8 * entry.index + i});
    }
  }

  /// Opens the leaves of a node that their oriented boxes do not prove to be out of reach.
  ///
  /// @param squared  Lower bounds of the squared distances of the leaves.
  void open_near_leaves(Index node, const EightFloats& squared, unsigned near) {
    if (near == 0) return;
    const EightFloats bounds = max(squared, squared_distances(leaf_boxes_[node], clamped_));
    nearest_first(bounds.numbers(), near & within_reach(bounds),
                  [&](unsigned i) { open_leaf(8 * node + i); });
  }

  /// Considers the faces of a leaf that may hold the answer; their corners cull more than their
  /// boxes would, but those of far faces are in other places.
  void open_leaf(Index leaf) {
    if (tree_.is_far_leaf(leaf)) {
      return consider_lanes(leaf,
                            squared_distances(tree_.node(0, leaf), TreeBox{clamped_, clamped_}));
    }
    const EightCorners corners = seen_from(clamped_, triangles_[leaf]);
    if (within_reach(squared_distances(corners, rough_direction(corners))) == 0) {
      return;
    }
    consider_lanes(leaf, squared_distances(corners, fine_direction(corners)));
  }

  /// @param squared  Lower bounds of the squared distances of the leaf's faces.
  void consider_lanes(Index leaf, const EightFloats& squared) {
    nearest_first(squared.numbers(), within_reach(squared),
                  [&](unsigned i) { consider(8 * leaf + i); });
  }

  /// Calls `visit` with the nearest of some lanes, and with the others that are still within reach
  /// then. To sort them all takes longer than it saves.
  template <typename Visit>
  void nearest_first(const std::array<float, 8>& squared, unsigned lanes, const Visit& visit) {
    if (lanes == 0) {
      return;
    }
    auto nearest = static_cast<unsigned>(std::countr_zero(lanes));
    for (unsigned bits = lanes & (lanes - 1); bits != 0; bits &= bits - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(bits));
      nearest = squared[i] < squared[nearest] ? i : nearest;
    }
    visit(nearest);
    for (unsigned bits = lanes & ~(1U << nearest); bits != 0; bits &= bits - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(bits));
      if (squared[i] <= reach_) visit(i);
    }
  }

  /// Returns a mask in which bit i is set if number i is that of something within reach.
  [[nodiscard]] unsigned within_reach(const EightFloats& squared) const {
    return (squared <= EightFloats::all(reach_)).bits();
  }

  void consider(Index slot) {
    const Index face = tree_.mesh_face(slot);
    if (!query_.excluded.empty() && query_.excluded[face] != 0) {
      return;
    }
    if (query_.is_wanted != nullptr && !(*query_.is_wanted)(face)) {
      return;
    }
    const Corners corners = tree_.corners(slot);
    if (is_within_slack_ && is_box_farther(corners)) {
      return;
    }
    const std::optional<TrianglePoint> found =
        query_.cone ? closest_on_triangle(corners, query_.point, *query_.cone)
                    : closest_on_triangle(corners, query_.point);
    if (found && (found->distance < best_.distance ||
                  (found->distance == best_.distance && face < best_.mesh_face))) {
      best_ = {found->point, found->distance, face, slot};
      set_reach();
    }
  }

  /// Returns those of some children of a node that are not outside a cone.
  [[nodiscard]] unsigned those_in_cone(const Cone& cone, const EightBoxes& node,
                                       unsigned lanes) const {
    unsigned inside = 0;
    for (unsigned bits = lanes; bits != 0; bits &= bits - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(bits));
      inside |= static_cast<unsigned>(!is_outside(cone, node.box(i))) << i;
    }
    return inside;
  }

  /// Tells whether a plane along the side of the cone separates the cone from the box.
  [[nodiscard]] bool is_outside(const Cone& cone, const TreeBox& box) const {
    // The boxes of far faces are in other directions than these.
    if (tree_.has_far_faces()) return false;
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
    const bool is_face_found = best_.mesh_face != kNoIndex;
    if (is_face_found && query_.near_enough && best_.distance <= *query_.near_enough) {
      reach_ = -1.0F;
      return;
    }
    reach_ = squared_reach(tree_, best_.distance);
    is_within_slack_ = best_.distance * tree_.scale() < kAbsoluteSlack || tree_.has_far_faces();
  }

  /// Tells whether the box of a triangle is farther than the best face so far, in double precision,
  /// where the slack of the bounds in single precision is larger than what there is to tell: where
  /// some faces are a million times larger than others, all small ones lie at one place there.
  [[nodiscard]] bool is_box_farther(const Corners& corners) const {
    const Vec3 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
    const Vec3 high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
    const Vec3 gap = (low - query_.point).cwiseMax(query_.point - high).cwiseMax(0.0);
    return gap.squaredNorm() * kBelowRounding > best_.distance * best_.distance;
  }

  const FaceTree& tree_;
  std::span<const EightTriangles> triangles_;
  std::span<const EightOrientedBoxes> leaf_boxes_;
  const ClosestQuery& query_;
  /// The point of the query in the tree's coordinates.
  Vec3 place_;
  std::array<float, 3> clamped_;
  SurfacePoint best_;
  float reach_ = 0.0F;
  /// Tells whether the best distance so far is so small that single precision tells little.
  bool is_within_slack_ = false;
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
    : tree_(tree),
      triangles_(tree.n_leaves(), EightTriangles::none()),
      leaf_boxes_(n_chunks(tree.n_leaves(), kTreeWidth)) {
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
  parallel_chunks(leaf_boxes_.size(), kNodesOfLeavesPerChunk, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      leaf_boxes_[i] = oriented_boxes_of(tree, triangles_, kTreeWidth * i);
    }
  });
}

std::uint64_t ClosestPoints::bytes_for(std::size_t n_faces) {
  const std::size_t n_leaves = n_chunks(n_faces, kTreeWidth);
  return n_leaves * sizeof(EightTriangles) +
         n_chunks(n_leaves, kTreeWidth) * sizeof(EightOrientedBoxes);
}

bool ClosestPoints::may_be_within(const Box3& box, double distance) const {
  return has_leaf_near(
      tree_, tree_.n_levels() - 1, 0,
      {tree_.map_within(box.min(), kFarthest), tree_.map_within(box.max(), kFarthest)},
      squared_reach(tree_, distance));
}

std::optional<SurfacePoint> ClosestPoints::find(const ClosestQuery& query) const {
  return Search(tree_, triangles_, leaf_boxes_, query).run();
}

}  // namespace meshalyzer
