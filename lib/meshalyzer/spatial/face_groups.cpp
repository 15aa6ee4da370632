#include "meshalyzer/spatial/face_groups.h"

#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/eight_lanes.h"
#include "meshalyzer/base/runs.h"
#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/spatial/tree_width.h"

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

/// Fewer faces do not form a group: their pairs are searched as fast.
constexpr std::size_t kSmallestGroup = 8;

/// Fewer faces of a leaf that have the same box are no crowd: the two halves of a rectangle along
/// the axes have it too.
constexpr int kSmallestCrowd = 3;

/// Returns the lanes of a leaf whose faces have the same box as the one in lane i, as bits.
unsigned lanes_like(const EightBoxes& boxes, std::size_t i) {
  unsigned alike = 0xFFU;
  for (std::size_t k = 0; k < 3 && std::popcount(alike) > 1; ++k) {
    for (const std::array<float, 8>* ends : {&boxes.min[k], &boxes.max[k]}) {
      const EightFloats mine = EightFloats::all((*ends)[i]);
      const EightFloats all = EightFloats::load(*ends);
      alike &= ~((mine < all) | (all < mine)).bits();
    }
  }
  return alike;
}

/// Returns the slots of faces whose box equals those of other faces of their leaf: nearly all faces
/// of a crowd at one place, which the tree cannot separate.
std::vector<Index> slots_in_crowds(const FaceTree& tree) {
  std::vector<Index> slots;
  for (std::size_t leaf = 0; leaf < tree.n_faces() / kTreeWidth; ++leaf) {
    const EightBoxes& boxes = tree.node(0, leaf);
    if (std::popcount(lanes_like(boxes, 0)) < kSmallestCrowd) continue;  // the faces are no crowd
    for (std::size_t i = 0; i < kTreeWidth; ++i) {
      if (std::popcount(lanes_like(boxes, i)) >= kSmallestCrowd) {
        slots.push_back(static_cast<Index>(kTreeWidth * leaf + i));
      }
    }
  }
  return slots;
}

using Place = std::tuple<double, double, double>;

/// Returns the positions of a face's corners, ascending.
std::array<Place, 3> places_of(const FaceTree& tree, std::size_t slot) {
  const Corners corners = tree.corners(slot);
  std::array<Place, 3> places;
  std::transform(corners.begin(), corners.end(), places.begin(),
                 [](const Vec3& p) { return Place(p.x(), p.y(), p.z()); });
  std::sort(places.begin(), places.end());
  return places;
}

/// Returns for each vertex the number of faces that use it.
std::vector<Index> count_uses(const FaceTree& tree) {
  std::vector<Index> uses(tree.n_points(), 0);
  for (std::size_t slot = 0; slot < tree.n_faces(); ++slot) {
    for (const Index v : tree.triangle(slot)) ++uses[v];
  }
  return uses;
}

}  // namespace

FaceGroups::FaceGroups(const CutMesh& cut, const FaceTree& tree) {
  std::vector<Index> slots = slots_in_crowds(tree);
  if (slots.empty()) return;
  const std::vector<Index> uses = count_uses(tree);
  const auto places = [&](Index slot) { return places_of(tree, slot); };
  const auto vertices = [&](Index slot) { return sorted_corners(tree.triangle(slot)); };
  const auto key = [&](Index slot) { return std::pair(places(slot), vertices(slot)); };
  std::sort(slots.begin(), slots.end(), [&](Index a, Index b) { return key(a) < key(b); });
  const auto is_loose = [&](Index slot) {
    const Triangle& t = tree.triangle(slot);
    return std::all_of(t.begin(), t.end(), [&](Index v) { return uses[v] == 1; });
  };
  for_each_run(std::span(std::as_const(slots)), places, [&](std::span<const Index> at_one_place) {
    std::vector<Index> loose;
    for_each_run(at_one_place, vertices, [&](std::span<const Index> one_face) {
      add(cut, tree, one_face);
      if (one_face.size() == 1 && is_loose(one_face[0])) loose.push_back(one_face[0]);
    });
    add(cut, tree, loose);
  });
  std::sort(groups_.begin(), groups_.end(),
            [](const Group& a, const Group& b) { return a.slots < b.slots; });
}

/// Adds a group unless it is too small.
void FaceGroups::add(const CutMesh& cut, const FaceTree& tree, std::span<const Index> slots) {
  if (slots.size() < kSmallestGroup) return;
  left_out_.resize(tree.n_leaves(), 0);
  Group& group = groups_.emplace_back(Group{{slots[0], slots[1]}, {}});
  for (const Index slot : slots) {
    group.faces.push_back(cut.side.faces[tree.mesh_face(slot)]);
    if (slot != slots[0]) {
      left_out_[slot / 8] = static_cast<std::uint8_t>(left_out_[slot / 8] | 1U << (slot % 8));
    }
  }
  std::sort(group.faces.begin(), group.faces.end());
}

std::span<const Index> FaceGroups::faces_at(std::size_t slot) const {
  const auto found =
      std::lower_bound(groups_.begin(), groups_.end(), slot,
                       [](const Group& group, std::size_t at) { return group.slots[0] < at; });
  if (found == groups_.end() || found->slots[0] != slot) return {};
  return found->faces;
}

}  // namespace meshalyzer
