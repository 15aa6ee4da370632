#include "meshalyzer/repair/holes/internal/patch_check.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/repair/rules/internal/contact_rule.h"
#include "meshalyzer/spatial/box_meetings.h"
#include "meshalyzer/spatial/self_intersection.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <utility>

namespace meshalyzer {
namespace {

PlacedFace placed(const FaceTree& tree, std::size_t slot) {
  return {tree.triangle(slot), tree.corners(slot)};
}

/// Tells whether a pair of faces of patches counts: not if they meet only at copies of a vertex.
bool counts(const Soup& soup, const IntersectingPair& pair) {
  const auto placed_face = [&](Index f) {
    return PlacedFace{soup.triangles[f], corners_of(soup, f)};
  };
  return pair.kind != ContactKind::Unwelded ||
         are_in_contact_beyond_copies(placed_face(pair.face_a), placed_face(pair.face_b));
}

/// Returns the intersections of patches with themselves and each other that count.
std::vector<IntersectingPair> own_intersections(const Soup& soup, const CutMesh& cut,
                                                const FaceTree& tree) {
  std::vector<IntersectingPair> pairs = find_self_intersections(cut, tree);
  std::erase_if(pairs, [&](const IntersectingPair& pair) { return !counts(soup, pair); });
  return pairs;
}

/// Notes whether a patch has a pair that counts.
class AnyPair : public PairListener {
 public:
  explicit AnyPair(const Soup& soup) : soup_(soup) {}

  [[nodiscard]] bool is_found() const { return is_found_; }

  void on_pairs(std::span<const IntersectingPair> pairs) override {
    for (const IntersectingPair& pair : pairs) look_at(pair);
  }
  void on_product(const PairProduct& product) override {
    for (const Index a : product.a) {
      for (const Index b : product.b) {
        if (is_found()) return;
        if (a != b) look_at({.face_a = a, .face_b = b, .kind = product.kind});
      }
    }
  }

 private:
  void look_at(const IntersectingPair& pair) {
    if (!is_found() && counts(soup_, pair)) is_found_ = true;
  }

  const Soup& soup_;
  std::atomic<bool> is_found_ = false;
};

bool intersects_itself(const Soup& soup, const CutMesh& cut, const FaceTree& tree) {
  AnyPair any(soup);
  PairLimits limits;
  limits.wants_to_stop = [&] { return any.is_found(); };
  visit_self_intersections(cut, tree, limits, any);
  return any.is_found();
}

/// A patch, and the tree of its faces.
class PlacedPatch {
 public:
  PlacedPatch(const PreparedMesh& mesh, const Patch& patch)
      : mesh_(mesh),
        patch_(patch),
        own_(make_soup(mesh.soup(), patch)),
        cut_(build(own_.soup)),
        tree_(cut_) {}

  [[nodiscard]] const Soup& soup() const { return own_.soup; }
  [[nodiscard]] const CutMesh& cut() const { return cut_; }
  [[nodiscard]] const FaceTree& tree() const { return tree_; }

  [[nodiscard]] bool is_torn() const {
    return cut_.side.faces.size() != own_.soup.n_faces() || !cut_.side.copies.empty() ||
           cut_.side.non_manifold_edges.size() != 0 || cut_.side.flipped_edges.size() != 0;
  }

  [[nodiscard]] Index face(std::size_t slot) const {
    return cut_.side.faces[tree_.mesh_face(slot)];
  }

  /// Tells whether a face of the patch is in contact with one of the mesh.
  [[nodiscard]] bool are_meeting(std::size_t slot, std::size_t mesh_slot) const {
    const Triangle& t = patch_.triangles[face(slot)];
    return are_in_contact_beyond_copies({t, corners_of(mesh_.soup(), patch_, t)},
                                        placed(mesh_.tree(), mesh_slot));
  }

 private:
  const PreparedMesh& mesh_;
  const Patch& patch_;
  PatchSoup own_;
  CutMesh cut_;
  FaceTree tree_;
};

/// Tells for each face of a patch whether it is in contact with the mesh.
std::vector<std::uint8_t> find_meeting_faces(const PreparedMesh& mesh, const Patch& patch) {
  const PlacedPatch placed(mesh, patch);
  std::vector<std::uint8_t> is_meeting(patch.triangles.size(), 0);
  const BoxMeetings meetings(placed.tree(), mesh.tree());
  meetings.run([&](std::size_t, std::size_t slot, std::size_t mesh_slot) {
    const std::atomic_ref known(is_meeting[placed.face(slot)]);
    if (known.load(std::memory_order_relaxed) == 0 && placed.are_meeting(slot, mesh_slot)) {
      known.store(1, std::memory_order_relaxed);
    }
    return BoxMeetings::Next::GoOn;
  });
  return is_meeting;
}

}  // namespace

const Vec3& position_of(const Soup& mesh, const Patch& patch, Index v) {
  return v < mesh.n_vertices() ? mesh.positions[v] : patch.added[v - mesh.n_vertices()];
}

Corners corners_of(const Soup& mesh, const Patch& patch, const Triangle& t) {
  return {position_of(mesh, patch, t[0]), position_of(mesh, patch, t[1]),
          position_of(mesh, patch, t[2])};
}

PatchSoup make_soup(const Soup& mesh, const Patch& patch) {
  PatchSoup result;
  for (const Triangle& t : patch.triangles) {
    result.vertices.insert(result.vertices.end(), t.begin(), t.end());
  }
  sort_unique(result.vertices);
  for (const Index v : result.vertices) {
    result.soup.positions.push_back(position_of(mesh, patch, v));
  }
  result.soup.triangles = patch.triangles;
  for (Triangle& t : result.soup.triangles) {
    for (Index& v : t) {
      v = static_cast<Index>(std::lower_bound(result.vertices.begin(), result.vertices.end(), v) -
                             result.vertices.begin());
    }
  }
  return result;
}

PatchFaults TriangulationChecker::check(const Patch& patch) {
  PatchFaults faults;
  const PlacedPatch placed(mesh_, patch);
  faults.is_torn = placed.is_torn();
  if (faults.is_torn) return faults;
  for (const IntersectingPair& pair :
       own_intersections(placed.soup(), placed.cut(), placed.tree())) {
    faults.meeting.push_back(pair.face_a);
    faults.meeting.push_back(pair.face_b);
  }
  compare_new_triangles(patch);
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    if (is_meeting_.at(patch.triangles[i])) faults.meeting.push_back(static_cast<Index>(i));
  }
  sort_unique(faults.meeting);
  return faults;
}

void TriangulationChecker::compare_new_triangles(const Patch& patch) {
  Patch unknown;
  for (const Triangle& t : patch.triangles) {
    if (!is_meeting_.contains(t)) unknown.triangles.push_back(t);
  }
  if (unknown.triangles.empty()) return;
  const std::vector<std::uint8_t> is_meeting = find_meeting_faces(mesh_, unknown);
  for (std::size_t i = 0; i < unknown.triangles.size(); ++i) {
    is_meeting_.emplace(unknown.triangles[i], is_meeting[i] != 0);
  }
}

bool is_sound(const PreparedMesh& mesh, const Patch& patch) {
  const PlacedPatch placed(mesh, patch);
  if (placed.is_torn()) return false;
  const auto stop_at_contact = [&](std::size_t, std::size_t slot, std::size_t mesh_slot) {
    return placed.are_meeting(slot, mesh_slot) ? BoxMeetings::Next::Stop : BoxMeetings::Next::GoOn;
  };
  const BoxMeetings meetings(placed.tree(), mesh.tree());
  return meetings.run(stop_at_contact) == BoxMeetings::Next::GoOn &&
         !intersects_itself(placed.soup(), placed.cut(), placed.tree());
}

std::vector<Index> faces_met(const PreparedMesh& mesh, const Patch& patch) {
  const PlacedPatch placed(mesh, patch);
  if (placed.is_torn()) return {};
  const BoxMeetings meetings(placed.tree(), mesh.tree());
  std::vector<std::vector<Index>> parts(meetings.n_chunks());
  meetings.run([&](std::size_t chunk, std::size_t slot, std::size_t mesh_slot) {
    if (placed.are_meeting(slot, mesh_slot)) {
      parts[chunk].push_back(mesh.cut().side.faces[mesh.tree().mesh_face(mesh_slot)]);
    }
    return BoxMeetings::Next::GoOn;
  });
  std::vector<Index> met;
  for (const auto& part : parts) met.insert(met.end(), part.begin(), part.end());
  sort_unique(met);
  return met;
}

std::vector<std::uint8_t> keep_apart(const PreparedMesh& mesh, std::span<const Patch> patches) {
  // All patches form one mesh: they have no common vertex except the numbers of added ones.
  Patch all;
  std::vector<Index> patch_of;
  const auto n_vertices = static_cast<Index>(mesh.soup().n_vertices());
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const auto shift = static_cast<Index>(all.added.size());
    for (Triangle t : patches[i].triangles) {
      for (Index& v : t) v += v >= n_vertices ? shift : 0;
      all.triangles.push_back(t);
      patch_of.push_back(static_cast<Index>(i));
    }
    all.added.insert(all.added.end(), patches[i].added.begin(), patches[i].added.end());
  }
  std::vector<std::uint8_t> is_kept(patches.size(), 1);
  if (patches.size() < 2) return is_kept;
  const PatchSoup together = make_soup(mesh.soup(), all);
  const CutMesh cut = build(together.soup);
  std::vector<std::array<Index, 2>> clashes;
  for (const IntersectingPair& pair : own_intersections(together.soup, cut, FaceTree(cut))) {
    const auto [first, second] = std::minmax(patch_of[pair.face_a], patch_of[pair.face_b]);
    if (first != second) clashes.push_back({second, first});
  }
  // The pairs are ordered by the later patch, so that it is already known whether the earlier one
  // is kept.
  std::sort(clashes.begin(), clashes.end());
  for (const auto& [later, earlier] : clashes) {
    if (is_kept[earlier] != 0) is_kept[later] = 0;
  }
  return is_kept;
}

}  // namespace meshalyzer
