#include "meshalyzer/spatial/box_meetings.h"

#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace meshalyzer {
namespace {

using Next = BoxMeetings::Next;

/// The number of leaves that one task searches.
constexpr std::size_t kOuterLeavesPerChunk = 16;
/// One in this many leaves is sampled to estimate the cost of the search.
constexpr std::size_t kSampled = 64;
/// A search is costly if it meets more boxes than this for each face of the inner tree. A mesh
/// against itself meets about 15.
constexpr std::size_t kMetPerFace = 64;
/// Sums of three products of coordinates up to 1 are off by less than this.
constexpr float kRelativeRounding = 0x1p-20F;
/// Corners farther out than this are not compared with slabs.
constexpr float kFarthestForSlabs = 0x1p+20F;

/// Returns a point of another mesh in the coordinates of a tree. The map is monotone in each
/// coordinate, like FaceTree::map(), so boxes that meet in space meet there.
///
/// The result is finite for any finite point, because differences of infinities would be useless.
std::array<float, 3> map_foreign(const FaceTree& tree, const Vec3& point) {
  return tree.map_within(point, std::numeric_limits<float>::max());
}

/// Returns the leaves of `tree` whose boxes meet the box of all faces of `other`, ascending.
std::vector<Index> leaves_near(const FaceTree& tree, const FaceTree& other) {
  if (tree.n_faces() == 0 || other.n_faces() == 0) {
    return {};
  }
  const TreeBox box{map_foreign(tree, other.bounds().min()),
                    map_foreign(tree, other.bounds().max())};
  std::vector<Index> nodes{0};
  for (std::size_t level = tree.n_levels() - 1; level > 0; --level) {
    std::vector<Index> below;
    for (const Index i : nodes) {
      for (unsigned bits = tree.node(level, i).meeting(box); bits != 0; bits &= bits - 1) {
        below.push_back(8 * i + static_cast<Index>(std::countr_zero(bits)));
      }
    }
    nodes = std::move(below);
  }
  return nodes;
}

/// Returns a box in the coordinates of `to` round all points that are in a box of the faces of
/// `from`, in spite of rounding; nothing if some number is too large for that.
///
/// With u = 2^-53: a coordinate in `from` is that of a point, at most 1, rounded to float. To map
/// it back takes three roundings, and to subtract the other centre one more, each of less than u of
/// the largest number below. The map to `to` takes two, each of u of its result.
std::optional<TreeBox> foreign_box(const FaceTree& from, const TreeBox& box, const FaceTree& to) {
  constexpr double kFloatSlack = 0x1p-23;
  constexpr double kSlack = 0x1p-49;
  constexpr double kFarthest = std::numeric_limits<float>::max();
  TreeBox foreign{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const double size = 1.0 / from.scale();
    const double slack =
        kSlack * (size + std::abs(from.centre()[axis]) + std::abs(to.centre()[axis]));
    const auto place = [&](float x, double side) {
      const double point =
          (static_cast<double>(x) + side * kFloatSlack) * size + from.centre()[axis];
      const double there = (point + side * slack - to.centre()[axis]) * to.scale();
      return there + side * kSlack * std::abs(there);
    };
    const double low = place(box.low[k], -1.0);
    const double high = place(box.high[k], 1.0);
    if (!std::isfinite(low) || !std::isfinite(high)) return std::nullopt;
    foreign.low[k] = static_cast<float>(std::clamp(low, -kFarthest, kFarthest));
    foreign.high[k] = static_cast<float>(std::clamp(high, -kFarthest, kFarthest));
  }
  return foreign;
}

/// Tells whether a box meets that of a leaf below a node, or of a face if the node is a leaf.
bool meets_leaf(const FaceTree& tree, std::size_t level, std::size_t i, const TreeBox& box) {
  unsigned bits = tree.node(level, i).meeting(box);
  if (level <= 1) return bits != 0;
  for (; bits != 0; bits &= bits - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
    if (meets_leaf(tree, level - 1, 8 * i + lane, box)) return true;
  }
  return false;
}

/// Tells whether a leaf of one tree may have a face whose box meets that of a leaf of another. It
/// asks for the box of the leaf, which is much less work than to map the corners of its faces.
bool may_meet(const FaceTree& outer, std::size_t leaf, const FaceTree& inner) {
  if (outer.has_far_faces() || inner.has_far_faces()) return true;
  const std::optional<TreeBox> box =
      foreign_box(outer, TreeBox::around(outer.node(0, leaf)), inner);
  return !box || meets_leaf(inner, inner.n_levels() - 1, 0, *box);
}

/// A leaf of the outer tree that is to be compared with the inner one.
struct Visit {
  const FaceTree& outer;
  const FaceTree& inner;
  /// The slabs of the inner tree, or null if there are none.
  const SlabTree* slabs;
  /// Receives a slot of the outer tree, then one of the inner.
  const BoxMeetings::Meet& meet;
  std::size_t chunk;
  std::size_t leaf;
};

/// Returns the corners of the leaf's faces in the coordinates of the inner tree.
LeafTriangles corners_of_leaf(const Visit& visit) {
  LeafTriangles faces(visit.outer, visit.leaf);
  const std::size_t last = visit.outer.n_faces() - 1;
  for (std::size_t i = 0; i < 8; ++i) {
    const Triangle& t = visit.outer.triangle(std::min(8 * visit.leaf + i, last));
    for (std::size_t c = 0; c < 3; ++c) {
      const auto p = map_foreign(visit.inner, visit.outer.point(t[c]));
      for (std::size_t k = 0; k < 3; ++k) {
        faces.corners[c][k][i] = p[k];
      }
    }
  }
  return faces;
}

/// Returns the boxes of the leaf's faces in the coordinates of the inner tree.
EightBoxes boxes_of_leaf(const Visit& visit) {
  EightBoxes boxes = EightBoxes::empty();
  const std::size_t n = std::min<std::size_t>(8, visit.outer.n_faces() - 8 * visit.leaf);
  for (std::size_t i = 0; i < n; ++i) {
    for (const Index v : visit.outer.triangle(8 * visit.leaf + i)) {
      const auto p = map_foreign(visit.inner, visit.outer.point(v));
      for (std::size_t k = 0; k < 3; ++k) {
        boxes.min[k][i] = std::min(boxes.min[k][i], p[k]);
        boxes.max[k][i] = std::max(boxes.max[k][i], p[k]);
      }
    }
  }
  return boxes;
}

/// Returns the largest magnitude of a coordinate of a box.
float reach_of(const TreeBox& box) {
  float reach = 0.0F;
  for (std::size_t k = 0; k < 3; ++k) {
    reach = std::max({reach, std::abs(box.low[k]), std::abs(box.high[k])});
  }
  return reach;
}

/// Compares the eight faces of one leaf with those faces of the inner tree whose boxes meet theirs.
class LeafVisitor {
 public:
  explicit LeafVisitor(const Visit& visit)
      : visit_(visit),
        inner_(visit.inner),
        mine_(boxes_of_leaf(visit)),
        box_(TreeBox::around(mine_)),
        slack_(kRelativeRounding * reach_of(box_)) {
    const float farthest = inner_.has_far_faces() ? 1.0F : kFarthestForSlabs;
    if (visit.slabs != nullptr && reach_of(box_) < farthest) {
      corners_.emplace(corners_of_leaf(visit));
    }
  }

  Next visit() {
    const std::size_t top = inner_.n_levels() - 1;
    return descend(top, 0, TreeBox::around(inner_.node(top, 0)));
  }

 private:
  /// @param box  The box of all faces below the node.
  Next descend(std::size_t level, std::size_t i, const TreeBox& box) {
    if (corners_ && is_excluded(visit_.slabs->slabs(level, i))) {
      return Next::GoOn;
    }
    if (level == 0) {
      return meet_leaf(i, box);
    }
    const EightBoxes& boxes = inner_.node(level, i);
    for (unsigned bits = boxes.meeting(box_); bits != 0; bits &= bits - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
      if (descend(level - 1, 8 * i + lane, boxes.box(lane)) == Next::Stop) {
        return Next::Stop;
      }
    }
    return Next::GoOn;
  }

  /// Slabs allow for the rounding of corners within the bounds of their own tree; these corners may
  /// be farther out.
  bool is_excluded(const Slabs& slabs) const {
    if (!slabs.is_useful) {
      return false;
    }
    Slabs wider = slabs;
    for (std::size_t a = 0; a < 2; ++a) {
      wider.low[a] -= slack_;
      wider.high[a] += slack_;
    }
    return wider.exclude(*corners_);
  }

  Next meet_leaf(std::size_t other, const TreeBox& box) {
    const EightBoxes& theirs = inner_.node(0, other);
    for (unsigned near = mine_.meeting(box); near != 0; near &= near - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(near));
      for (unsigned bits = theirs.meeting(mine_.box(i)); bits != 0; bits &= bits - 1) {
        const std::size_t slot = 8 * other + static_cast<std::size_t>(std::countr_zero(bits));
        if (visit_.meet(visit_.chunk, 8 * visit_.leaf + i, slot) == Next::Stop) {
          return Next::Stop;
        }
      }
    }
    return Next::GoOn;
  }

  const Visit& visit_;
  const FaceTree& inner_;
  EightBoxes mine_;
  TreeBox box_;
  float slack_;
  /// The corners of the leaf, if they are to be compared with slabs.
  std::optional<LeafTriangles> corners_;
};

}  // namespace

BoxMeetings::BoxMeetings(const FaceTree& a, const FaceTree& b)
    : outer_(&a), inner_(&b), leaves_(leaves_near(a, b)) {
  std::vector<Index> leaves_of_b = leaves_near(b, a);
  if (leaves_of_b.size() < leaves_.size()) {
    swap_roles(std::move(leaves_of_b));
  }
  if (is_laborious()) {
    make_slabs();
  }
}

std::size_t BoxMeetings::n_chunks() const {
  return meshalyzer::n_chunks(leaves_.size(), kOuterLeavesPerChunk);
}

BoxMeetings::Next BoxMeetings::run(const Meet& meet) const {
  const Meet swapped = [&](std::size_t chunk, std::size_t b, std::size_t a) {
    return meet(chunk, a, b);
  };
  const Meet& in_order = is_swapped_ ? swapped : meet;
  std::atomic<bool> is_stopped = false;
  parallel_chunks(leaves_.size(), kOuterLeavesPerChunk, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end && !is_stopped; ++i) {
      if (!may_meet(*outer_, leaves_[i], *inner_)) continue;
      const Visit visit{.outer = *outer_,
                        .inner = *inner_,
                        .slabs = slabs_.get(),
                        .meet = in_order,
                        .chunk = chunk.number,
                        .leaf = leaves_[i]};
      if (LeafVisitor(visit).visit() == Next::Stop) {
        is_stopped = true;
      }
    }
  });
  return is_stopped ? Next::Stop : Next::GoOn;
}

void BoxMeetings::swap_roles(std::vector<Index> leaves) {
  std::swap(outer_, inner_);
  is_swapped_ = !is_swapped_;
  leaves_ = std::move(leaves);
}

/// Tells whether a sample of the leaves meets so many faces that building slabs may pay.
bool BoxMeetings::is_laborious() const {
  if (leaves_.empty()) {
    return false;
  }
  const std::size_t n_sampled = meshalyzer::n_chunks(leaves_.size(), kSampled);
  const std::size_t limit = kMetPerFace * inner_->n_faces() * n_sampled / leaves_.size();
  std::size_t n_met = 0;
  const Meet count = [&](std::size_t, std::size_t, std::size_t) {
    return ++n_met > limit ? Next::Stop : Next::GoOn;
  };
  for (std::size_t i = 0; i < leaves_.size(); i += kSampled) {
    const Visit visit{.outer = *outer_,
                      .inner = *inner_,
                      .slabs = nullptr,
                      .meet = count,
                      .chunk = 0,
                      .leaf = leaves_[i]};
    if (LeafVisitor(visit).visit() == Next::Stop) {
      return true;
    }
  }
  return false;
}

void BoxMeetings::make_slabs() {
  auto slabs = std::make_unique<const SlabTree>(*inner_);
  if (!slabs->has_useful()) {
    slabs = std::make_unique<const SlabTree>(*outer_);
    if (!slabs->has_useful()) {
      return;
    }
    swap_roles(leaves_near(*inner_, *outer_));
  }
  slabs_ = std::move(slabs);
}

}  // namespace meshalyzer
