#include "meshalyzer/spatial/partner_search.h"

#include "meshalyzer/base/eight_lanes.h"
#include "meshalyzer/spatial/contact_in_mesh.h"
#include "meshalyzer/spatial/leaf_frame.h"
#include "meshalyzer/spatial/separating_directions.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {
namespace {

/// Separating directions pay from this number of faces of a leaf that have possible partners in
/// another leaf, and from a smaller one where the corners of leaves are kept.
constexpr int kManyFaces = 3;
constexpr int kManyFacesOfKept = 2;

using Scene = SelfIntersectionScene;

/// Returns the lanes of a leaf whose faces are represented by others.
unsigned left_out(const Scene& scene, std::size_t leaf) {
  return scene.groups == nullptr ? 0U : scene.groups->left_out(leaf);
}

/// Returns the box of the wanted faces of a leaf.
TreeBox box_of_wanted(const Scene& scene, std::size_t leaf) {
  const EightBoxes& all = scene.tree.node(0, leaf);
  if (wanted_lanes(scene, leaf) == 0xFFU) return TreeBox::around(all);
  EightBoxes boxes = EightBoxes::empty();
  for (unsigned bits = wanted_lanes(scene, leaf); bits != 0; bits &= bits - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(bits));
    boxes.set(i, all.box(i));
  }
  return TreeBox::around(boxes);
}

/// Returns the proven vertices of a leaf's faces, kNoIndex for the others: a face that has one of
/// them in common with another needs no test against it.
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

/// The search of find_partners().
class PartnerSearch {
 public:
  PartnerSearch(const Scene& scene, std::size_t leaf, PairBuffer& found)
      : scene_(scene),
        tree_(scene.tree),
        found_(found),
        leaf_(leaf),
        wanted_(wanted_lanes(scene, leaf)),
        first_leaf_(scene.wanted.empty() ? leaf : 0),
        box_(box_of_wanted(scene, leaf)),
        fan_(scene.fans.fan(0, leaf)),
        proven_(proven_vertices(scene, leaf)) {}

  void run() {
    const std::size_t top = tree_.n_levels() - 1;
    descend(top, 0, TreeBox::around(tree_.node(top, 0)));
  }

  /// Returns the number of pairs of faces that were tested one by one.
  [[nodiscard]] std::size_t n_tested() const { return n_tested_; }

 private:
  /// @param box  The box of all faces below the node.
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

  /// Tells whether the slabs or the fan of a node prove that none of its faces meets the leaf's.
  bool is_excluded(std::size_t level, std::size_t i, const TreeBox& box) {
    if (scene_.slabs.has_useful()) {
      const Slabs& slabs = scene_.slabs.slabs(level, i);
      if (slabs.is_useful && slabs.exclude(triangles())) return true;
    }
    return fan_.hub != kNoIndex &&
           FanTree::meet_at_hub_only(fan_, box_, scene_.fans.fan(level, i), box);
  }

  /// The lanes of another leaf whose faces may meet the face in each lane of this one.
  using Partners = LeafFrame::Partners;

  void meet_leaf(std::size_t other, const TreeBox& box) {
    const EightBoxes& mine = tree_.node(0, leaf_);
    const EightBoxes& theirs = tree_.node(0, other);
    Partners partners = not_apart_in_frame(other, wanted_ & mine.meeting(box));
    const bool is_any_left =
        std::any_of(partners.begin(), partners.end(), [](unsigned lanes) { return lanes != 0; });
    if (!is_any_left) return;
    find_shared(other);
    int n_meeting = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      if (partners[i] == 0) continue;
      partners[i] &=
          theirs.meeting(mine.box(i)) & ~(done_lanes(other, i) | left_out(scene_, other));
      if (partners[i] != 0) {
        partners[i] &= ~settled_lanes(other, i);
      }
      n_meeting += static_cast<int>(partners[i] != 0);
    }
    if (n_meeting >= (scene_.slabs.has_useful() ? kManyFacesOfKept : kManyFaces)) {
      drop_separated(other, partners);
    }
    for (std::size_t i = 0; n_meeting != 0 && i < 8; ++i) {
      for (unsigned bits = partners[i]; bits != 0; bits &= bits - 1) {
        meet_face(8 * leaf_ + i, 8 * other + static_cast<std::size_t>(std::countr_zero(bits)));
      }
    }
  }

  /// Finds out what vertices this leaf and another one have in common.
  void find_shared(std::size_t other) {
    common_hubs_.clear();
    if (scene_.shared == nullptr) return;
    const std::span<const Index> near = scene_.shared->neighbours(leaf_);
    may_share_others_ = std::binary_search(near.begin(), near.end(), static_cast<Index>(other));
    const std::span<const LeafVertex> theirs = scene_.shared->hubs(other);
    for (const LeafVertex& mine : scene_.shared->hubs(leaf_)) {
      const auto same = std::find_if(theirs.begin(), theirs.end(), [&](const LeafVertex& hub) {
        return hub.vertex == mine.vertex;
      });
      if (same == theirs.end()) continue;
      const bool is_proven = !scene_.proven.empty() && scene_.proven[mine.vertex] != 0;
      common_hubs_.push_back({&mine, &*same, is_proven || mine.angles.is_apart_from(same->angles)});
    }
  }

  /// Returns for some of the faces, given as lanes, those of another leaf that the frame, if there
  /// is one, does not prove to be apart.
  Partners not_apart_in_frame(std::size_t other, unsigned lanes) {
    Partners partners;
    for (std::size_t i = 0; i < 8; ++i) partners[i] = (lanes >> i & 1U) != 0 ? 0xFFU : 0U;
    if (lanes != 0 && has_frame()) frame().drop_apart(scene_.slabs.triangles(other), partners);
    return partners;
  }

  /// Drops partners that are surely apart: neighbours by the angles of their corners, others by
  /// directions with a gap between them.
  void drop_separated(std::size_t other, Partners& partners) {
    std::optional<LeafTriangles> made;
    const LeafTriangles* theirs =
        scene_.slabs.has_useful() ? &scene_.slabs.triangles(other) : nullptr;
    for (std::size_t i = 0; i < 8; ++i) {
      if (partners[i] == 0) continue;
      const Neighbours near = neighbours(other, i, partners[i]);
      partners[i] &= ~near.apart;
      const unsigned strangers = partners[i] & ~near.all;
      if (strangers == 0) continue;
      if (theirs == nullptr) theirs = &made.emplace(tree_, other);
      partners[i] &= ~strangers | directions(i).perhaps_meeting(*theirs, strangers);
    }
  }

  const LeafTriangles& triangles() {
    if (scene_.slabs.has_useful()) return scene_.slabs.triangles(leaf_);
    if (!triangles_) triangles_.emplace(tree_, leaf_);
    return *triangles_;
  }

  /// Whether the faces of the leaf are long and thin.
  bool has_frame() const {
    return scene_.slabs.has_useful() && scene_.slabs.slabs(0, leaf_).has_axes();
  }

  const LeafFrame& frame() {
    if (!frame_) frame_.emplace(triangles(), scene_.slabs.slabs(0, leaf_).axis);
    return *frame_;
  }

  const SeparatingDirections& directions(std::size_t i) {
    if (!directions_[i]) directions_[i].emplace(triangles(), i);
    return *directions_[i];
  }

  /// Those faces of a leaf that have a vertex in common with a given one, as lanes, and those of
  /// them that surely share nothing else with it.
  struct Neighbours {
    unsigned all = 0;
    unsigned apart = 0;
  };

  Neighbours neighbours(std::size_t other, std::size_t i, unsigned lanes) const {
    if (!may_share_others_) return neighbours_at_hubs(other, i, lanes);
    Neighbours found;
    for (std::size_t c = 0; c < 3; ++c) {
      const EightIds mine = EightIds::all(tree_.leaf_faces(leaf_).corners[c][i]);
      for (std::size_t k = 0; k < 3; ++k) {
        const EightIds theirs = EightIds::load(tree_.leaf_faces(other).corners[k]);
        const unsigned common = (mine == theirs).bits() & lanes;
        found.all |= common;
        if (scene_.angles == nullptr) continue;
        for (unsigned bits = common; bits != 0; bits &= bits - 1) {
          const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
          const bool is_apart = scene_.angles->are_apart(8 * leaf_ + i, c, 8 * other + lane, k);
          found.apart |= static_cast<unsigned>(is_apart) << lane;
        }
      }
    }
    return found;
  }

  Neighbours neighbours_at_hubs(std::size_t other, std::size_t i, unsigned lanes) const {
    Neighbours found;
    for (const CommonHub& hub : common_hubs_) {
      const unsigned common = (hub.mine->lanes >> i & 1U) != 0 ? hub.theirs->lanes & lanes : 0U;
      found.all |= common;
      if (scene_.angles == nullptr) continue;
      for (unsigned bits = common; bits != 0; bits &= bits - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
        const bool is_apart = scene_.angles->are_apart(8 * leaf_ + i, hub.mine->corner(i),
                                                       8 * other + lane, hub.theirs->corner(lane));
        found.apart |= static_cast<unsigned>(is_apart) << lane;
      }
    }
    return found;
  }

  /// Returns the lanes of a leaf whose faces have a vertex in common with the face in lane i that
  /// is proven, or at which the faces of both leaves are seen at different angles.
  unsigned settled_lanes(std::size_t other, std::size_t i) const {
    unsigned settled = 0;
    for (const CommonHub& hub : common_hubs_) {
      if (hub.is_settled && (hub.mine->lanes >> i & 1U) != 0) settled |= hub.theirs->lanes;
    }
    return may_share_others_ ? settled | lanes_with_proven_vertex(other, i) : settled;
  }

  unsigned lanes_with_proven_vertex(std::size_t other, std::size_t i) const {
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

  /// Returns the lanes of another leaf, or this one, that the face in lane i need not be tested
  /// against.
  unsigned done_lanes(std::size_t other, std::size_t i) const {
    if (other > leaf_) {
      return 0;
    }
    const unsigned up_to_this = (2U << i) - 1;
    return wanted_lanes(scene_, other) & (other == leaf_ ? up_to_this : 0xFFU);
  }

  void meet_face(std::size_t a, std::size_t b) {
    ++n_tested_;
    const std::optional<ContactKind> kind =
        find_contact_in_mesh(tree_, tree_.triangle(a), tree_.triangle(b));
    if (!kind) return;
    const Index f = scene_.cut.side.faces[tree_.mesh_face(a)];
    const Index g = scene_.cut.side.faces[tree_.mesh_face(b)];
    const PairProduct all{faces_at(a, f), faces_at(b, g), *kind};
    if (all.n_pairs() > 1) {
      found_.push(all);
    } else {
      found_.push({.face_a = std::min(f, g), .face_b = std::max(f, g), .kind = *kind});
    }
  }

  /// Returns the faces that the one at a slot represents: in most cases only itself.
  std::span<const Index> faces_at(std::size_t slot, const Index& file_face) const {
    const std::span<const Index> group =
        scene_.groups == nullptr ? std::span<const Index>() : scene_.groups->faces_at(slot);
    return group.empty() ? std::span(&file_face, 1) : group;
  }

  const Scene& scene_;
  const FaceTree& tree_;
  PairBuffer& found_;
  std::size_t leaf_;
  unsigned wanted_;
  /// Leaves before this one are not searched.
  std::size_t first_leaf_;
  TreeBox box_;
  const Fan& fan_;
  EightFaces proven_;
  /// The triangles of the leaf, if many pairs remain and there are no slabs, which keep them.
  std::optional<LeafTriangles> triangles_;
  std::optional<LeafFrame> frame_;
  /// A hub that this leaf and another one have in common.
  struct CommonHub {
    const LeafVertex* mine;
    const LeafVertex* theirs;
    /// Whether none of the faces of one share anything else with those of the other.
    bool is_settled;
  };
  std::vector<CommonHub> common_hubs_;
  /// Whether this leaf and another one may have vertices in common that are no hubs.
  bool may_share_others_ = true;
  std::array<std::optional<SeparatingDirections>, 8> directions_;
  std::size_t n_tested_ = 0;
};

}  // namespace

unsigned wanted_lanes(const SelfIntersectionScene& scene, std::size_t leaf) {
  return scene.wanted.empty() ? 0xFFU & ~left_out(scene, leaf) : scene.wanted[leaf];
}

std::size_t find_partners(const SelfIntersectionScene& scene, std::size_t leaf, PairBuffer& found) {
  PartnerSearch search(scene, leaf, found);
  search.run();
  return search.n_tested();
}

}  // namespace meshalyzer
