#include "meshalyzer/spatial/self_intersection_search.h"

#include "meshalyzer/base/eight_lanes.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/spatial/align_faces.h"
#include "meshalyzer/spatial/join_pairs.h"
#include "meshalyzer/spatial/separating_directions.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <utility>

namespace meshalyzer {
namespace {

/// Leaves that one task looks at.
constexpr std::size_t kLeavesPerChunk = 64;

/// Leaves after which a search that may end early looks whether it has found enough.
constexpr std::size_t kLeavesPerRound = 64 * kLeavesPerChunk;

/// From this number of faces of a leaf on that have partners in another leaf it pays to look for
/// directions that separate them.
constexpr int kManyFaces = 2;

Corners corners_of(const FaceTree& tree, const Triangle& t) {
  return {tree.point(t[0]), tree.point(t[1]), tree.point(t[2])};
}

std::optional<ContactKind> contact_of(const FaceTree& tree, const AlignedFaces<Index>& pair) {
  return find_contact(corners_of(tree, pair.p), corners_of(tree, pair.q),
                      static_cast<Common>(pair.n_common));
}

/// Whether no two corners of a face are at one place.
bool has_three_places(const FaceTree& tree, const Triangle& t) {
  const Corners c = corners_of(tree, t);
  return c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
}

/// Whether two faces touch by being next to each other along a seam that was never welded, which
/// is asked first because it is cheaper than the kind of contact: they have a corner in common by
/// place that they have not by id, and share nothing else when vertices at identical places count
/// as one.
bool are_unwelded_neighbours(const FaceTree& tree, const AlignedFaces<Index>& by_id,
                             const AlignedFaces<Index>& by_place) {
  return by_place.n_common > by_id.n_common && by_id.n_common < 2 &&
         has_three_places(tree, by_id.p) && has_three_places(tree, by_id.q) &&
         !contact_of(tree, by_place);
}

std::optional<ContactKind> find_kind(const FaceTree& tree, const Triangle& p, const Triangle& q) {
  const AlignedFaces<Index> by_id = align_faces(p, q, [](Index a, Index b) { return a == b; });
  const AlignedFaces<Index> by_place = align_faces(
      by_id.p, by_id.q, [&](Index a, Index b) { return tree.point(a) == tree.point(b); });
  if (are_unwelded_neighbours(tree, by_id, by_place)) return ContactKind::Unwelded;
  const std::optional<ContactKind> kind = contact_of(tree, by_id);
  // The contact is gone when vertices at identical places count as one.
  const bool is_unwelded =
      kind && by_place.n_common > by_id.n_common && !contact_of(tree, by_place);
  return is_unwelded ? ContactKind::Unwelded : kind;
}

using Pairs = std::vector<IntersectingPair>;
using Scene = SelfIntersectionScene;

/// Returns the lanes of a leaf whose faces are wanted.
unsigned wanted_lanes(const Scene& scene, std::size_t leaf) {
  return scene.wanted.empty() ? 0xFFU : scene.wanted[leaf];
}

/// The box of the wanted faces of a leaf.
TreeBox box_of_wanted(const Scene& scene, std::size_t leaf) {
  const EightBoxes& all = scene.tree.node(0, leaf);
  EightBoxes boxes = EightBoxes::empty();
  for (unsigned bits = wanted_lanes(scene, leaf); bits != 0; bits &= bits - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(bits));
    for (std::size_t k = 0; k < 3; ++k) {
      boxes.min[k][i] = all.min[k][i];
      boxes.max[k][i] = all.max[k][i];
    }
  }
  return TreeBox::around(boxes);
}

/// The vertices of a leaf's faces that are proven, kNoIndex for the others: whoever has one of them
/// in common with the face needs no test.
EightFaces proven_vertices(const Scene& scene, std::size_t leaf) {
  EightFaces faces = scene.tree.leaf_faces(leaf);
  for (auto& corner : faces.corners) {
    for (Index& v : corner) {
      if (v != kNoIndex && (scene.proven.empty() || scene.proven[v] == 0)) {
        v = kNoIndex;
      }
    }
  }
  return faces;
}

/// Looks for the partners of the wanted faces of one leaf. Those that are wanted too and come
/// before are left out: they have found the pair themselves.
class PartnerSearch {
 public:
  PartnerSearch(const Scene& scene, std::size_t leaf, Pairs& found)
      : scene_(scene),
        tree_(scene.tree),
        found_(found),
        leaf_(leaf),
        wanted_(wanted_lanes(scene, leaf)),
        first_leaf_(scene.wanted.empty() ? leaf : 0),
        box_(box_of_wanted(scene, leaf)),
        proven_(proven_vertices(scene, leaf)) {
    if (scene.slabs.has_useful()) {
      corners_.emplace(tree_, leaf);
    }
  }

  void run() {
    const std::size_t top = tree_.n_levels() - 1;
    descend(top, 0, TreeBox::around(tree_.node(top, 0)));
  }

 private:
  /// @param box  Of all faces below the node.
  void descend(std::size_t level, std::size_t i, const TreeBox& box) {
    if (level == 0) {
      meet_leaf(i, box);
      return;
    }
    const std::size_t leaves_per_child = std::size_t{1} << (3 * (level - 1));
    const EightBoxes& boxes = tree_.node(level, i);
    for (unsigned bits = boxes.meeting(box_); bits != 0; bits &= bits - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
      const std::size_t child = 8 * i + lane;
      if ((child + 1) * leaves_per_child > first_leaf_) {
        const TreeBox child_box = boxes.box(lane);
        if (!is_excluded(level - 1, child, child_box)) {
          descend(level - 1, child, child_box);
        }
      }
    }
  }

  /// Whether boxes serve a node badly, but its slabs or its fan tell that none of its faces meets
  /// the leaf's.
  bool is_excluded(std::size_t level, std::size_t i, const TreeBox& box) const {
    const Slabs& slabs = scene_.slabs.slabs(level, i);
    if (slabs.is_useful && slabs.exclude(*corners_)) {
      return true;
    }
    return FanTree::meet_at_hub_only(scene_.fans.fan(0, leaf_), box_, scene_.fans.fan(level, i),
                                     box);
  }

  /// The lanes of another leaf whose faces may meet the face in each lane of this one.
  using Partners = std::array<unsigned, 8>;

  void meet_leaf(std::size_t other, const TreeBox& box) {
    const EightBoxes& mine = tree_.node(0, leaf_);
    const EightBoxes& theirs = tree_.node(0, other);
    Partners partners{};
    int n_meeting = 0;
    for (unsigned lanes = wanted_ & mine.meeting(box); lanes != 0; lanes &= lanes - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(lanes));
      unsigned bits = theirs.meeting(mine.box(i)) & ~done_lanes(other, i);
      if (bits != 0) {
        bits &= ~settled_lanes(other, i);
      }
      partners[i] = bits;
      n_meeting += static_cast<int>(bits != 0);
    }
    if (n_meeting >= kManyFaces) {
      drop_separated(other, partners);
    }
    for (std::size_t i = 0; n_meeting != 0 && i < 8; ++i) {
      for (unsigned bits = partners[i]; bits != 0; bits &= bits - 1) {
        meet_face(8 * leaf_ + i, 8 * other + static_cast<std::size_t>(std::countr_zero(bits)));
      }
    }
  }

  void drop_separated(std::size_t other, Partners& partners) {
    if (!triangles_) {
      triangles_.emplace(tree_, leaf_);
    }
    const LeafTriangles theirs(tree_, other);
    for (std::size_t i = 0; i < 8; ++i) {
      if (partners[i] != 0) {
        if (!directions_[i]) {
          directions_[i].emplace(*triangles_, i);
        }
        partners[i] = directions_[i]->perhaps_meeting(theirs, partners[i]);
      }
    }
  }

  /// Returns the lanes of a leaf whose faces have a proven vertex in common with the face in lane
  /// i.
  unsigned settled_lanes(std::size_t other, std::size_t i) const {
    const EightFaces& theirs = tree_.leaf_faces(other);
    EightFlags common{};
    for (const auto& corner : theirs.corners) {
      const EightIds vertices = EightIds::load(corner);
      for (const auto& mine : proven_.corners) {
        common = common | (vertices == EightIds::all(mine[i]));
      }
    }
    return common.bits();
  }

  /// Returns the lanes of another leaf, or this one, that the face in lane i need not look at.
  unsigned done_lanes(std::size_t other, std::size_t i) const {
    if (other > leaf_) {
      return 0;
    }
    const unsigned up_to_this = (2U << i) - 1;
    return wanted_lanes(scene_, other) & (other == leaf_ ? up_to_this : 0xFFU);
  }

  void meet_face(std::size_t a, std::size_t b) {
    const std::optional<ContactKind> kind = find_kind(tree_, tree_.triangle(a), tree_.triangle(b));
    if (kind) {
      const Index f = scene_.cut.side.faces[tree_.mesh_face(a)];
      const Index g = scene_.cut.side.faces[tree_.mesh_face(b)];
      found_.push_back({.face_a = std::min(f, g), .face_b = std::max(f, g), .kind = *kind});
    }
  }

  const Scene& scene_;
  const FaceTree& tree_;
  Pairs& found_;
  std::size_t leaf_;
  unsigned wanted_;
  /// Leaves before it need no look.
  std::size_t first_leaf_;
  TreeBox box_;
  EightFaces proven_;
  /// The corners of the leaf, where slabs may tell faces apart.
  std::optional<LeafCorners> corners_;
  /// The triangles of the leaf, where many pairs are left.
  std::optional<LeafTriangles> triangles_;
  std::array<std::optional<SeparatingDirections>, 8> directions_;
};

/// The pairs of a chunk of leaves, in the order of the leaves: all, or at least max_pairs.
Pairs search_leaves(const Scene& scene, Chunk leaves) {
  Pairs pairs;
  for (std::size_t leaf = leaves.begin; leaf < leaves.end && pairs.size() < scene.max_pairs;
       ++leaf) {
    if (wanted_lanes(scene, leaf) != 0) {
      PartnerSearch(scene, leaf, pairs).run();
    }
  }
  return pairs;
}

}  // namespace

std::vector<IntersectingPair> search_self_intersections(const SelfIntersectionScene& scene) {
  const std::size_t n_leaves = scene.tree.n_leaves();
  // Whether enough is found is asked between rounds, so that it does not depend on the threads.
  const std::size_t leaves_per_round = scene.max_pairs == kAllPairs ? n_leaves : kLeavesPerRound;
  std::vector<Pairs> parts;
  std::size_t n_found = 0;
  for (std::size_t first = 0; first < n_leaves && n_found < scene.max_pairs;
       first += leaves_per_round) {
    const std::size_t n = std::min(leaves_per_round, n_leaves - first);
    const std::size_t n_before = parts.size();
    parts.resize(n_before + n_chunks(n, kLeavesPerChunk));
    parallel_chunks(n, kLeavesPerChunk, [&](Chunk chunk) {
      parts[n_before + chunk.number] =
          search_leaves(scene, {first + chunk.begin, first + chunk.end, chunk.number});
    });
    for (std::size_t i = n_before; i < parts.size(); ++i) n_found += parts[i].size();
  }
  Pairs pairs = join_pairs(std::move(parts));
  if (pairs.size() > scene.max_pairs) {
    pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(scene.max_pairs), pairs.end());
  }
  return pairs;
}

}  // namespace meshalyzer
