#include "meshalyzer/repair/holes/internal/patch_check.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/repair/driver/internal/contact_rule.h"
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
  const Triangle& t = tree.triangle(slot);
  return {t, {tree.point(t[0]), tree.point(t[1]), tree.point(t[2])}};
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

bool is_torn(const Soup& soup, const CutMesh& cut) {
  return cut.side.faces.size() != soup.n_faces() || !cut.side.copies.empty() ||
         cut.side.non_manifold_edges.size() != 0 || cut.side.flipped_edges.size() != 0;
}

/// Tells whether a face of a patch is in contact with one of the mesh.
bool are_meeting(const PatchSoup& patch, const FaceTree& tree, std::size_t slot,
                 const FaceTree& mesh_tree, std::size_t mesh_slot) {
  PlacedFace face = placed(tree, slot);
  for (Index& v : face.vertices) v = patch.vertices[v];
  return are_in_contact_beyond_copies(face, placed(mesh_tree, mesh_slot));
}

/// Adds the common faces of a patch and the mesh.
void find_meetings_with_mesh(const PreparedMesh& mesh, const PatchSoup& patch, const FaceTree& tree,
                             PatchFaults& faults) {
  const BoxMeetings meetings(tree, mesh.tree());
  std::vector<std::vector<std::array<Index, 2>>> parts(meetings.n_chunks());
  meetings.run([&](std::size_t chunk, std::size_t slot, std::size_t mesh_slot) {
    if (are_meeting(patch, tree, slot, mesh.tree(), mesh_slot)) {
      parts[chunk].push_back({tree.mesh_face(slot), mesh.tree().mesh_face(mesh_slot)});
    }
    return BoxMeetings::Next::GoOn;
  });
  for (const auto& part : parts) {
    for (const auto& [triangle, mesh_face] : part) {
      faults.meeting.push_back(triangle);
      faults.met_faces.push_back(mesh.cut().side.faces[mesh_face]);
    }
  }
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

PatchFaults check_patch(const PreparedMesh& mesh, const Patch& patch) {
  PatchFaults faults;
  const PatchSoup own = make_soup(mesh.soup(), patch);
  const CutMesh cut = build(own.soup);
  faults.is_torn = is_torn(own.soup, cut);
  if (faults.is_torn) return faults;
  const FaceTree tree(cut);
  for (const IntersectingPair& pair : own_intersections(own.soup, cut, tree)) {
    faults.meeting.push_back(pair.face_a);
    faults.meeting.push_back(pair.face_b);
  }
  find_meetings_with_mesh(mesh, own, tree, faults);
  sort_unique(faults.meeting);
  sort_unique(faults.met_faces);
  return faults;
}

bool is_sound(const PreparedMesh& mesh, const Patch& patch) {
  const PatchSoup own = make_soup(mesh.soup(), patch);
  const CutMesh cut = build(own.soup);
  if (is_torn(own.soup, cut)) return false;
  const FaceTree tree(cut);
  const auto stop_at_contact = [&](std::size_t, std::size_t slot, std::size_t mesh_slot) {
    return are_meeting(own, tree, slot, mesh.tree(), mesh_slot) ? BoxMeetings::Next::Stop
                                                                : BoxMeetings::Next::GoOn;
  };
  return BoxMeetings(tree, mesh.tree()).run(stop_at_contact) == BoxMeetings::Next::GoOn &&
         !intersects_itself(own.soup, cut, tree);
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
