#include "meshalyzer/repair/combine/track_combined.h"

#include "meshalyzer/base/require.h"
#include "meshalyzer/boolean/make_disjoint.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/mesh/orphans.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/edits/apply_edits.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/fix_defects.h"
#include "meshalyzer/spatial/mutual_intersection.h"
#include "meshalyzer/spatial/self_intersection.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// How often a difference is subtracted again where it still meets the others. Most that are parted
/// at all are so after one or two rounds.
constexpr int kRoundsOfKeepingOff = 3;

/// Makes edits of one operation that turns a mesh into the result.
class CombinedEdits {
 public:
  CombinedEdits(const Soup& source, const CombinedSolid& solid)
      : soup_(source),
        solid_(solid),
        stays_(source.n_faces(), 0),
        added_(solid.positions.size() - source.n_vertices(), kNoIndex) {}

  Edits make() {
    op_ = edits_.begin_operation();
    find_model();
    for (const CombinedFace& face : solid_.faces) take(face);
    for (Index f = 0; f < stays_.size(); ++f) {
      if (stays_[f] == 0) edits_.removed_faces.push_back({op_, f});
    }
    move_vertices();
    remove_orphans();
    return std::move(edits_);
  }

 private:
  [[nodiscard]] bool is_of_source(const CombinedFace& face) const {
    return face.origin < soup_.n_faces();
  }

  /// Patches are modelled on the first face of the source of which a part stays.
  void find_model() {
    const auto found = std::find_if(solid_.faces.begin(), solid_.faces.end(),
                                    [&](const CombinedFace& face) { return is_of_source(face); });
    if (found != solid_.faces.end()) model_ = found->origin;
  }

  void take(const CombinedFace& face) {
    const std::optional<Triangle> corners = whole_face(solid_, soup_, face);
    if (!corners) {
      add(face);
      return;
    }
    stays_[face.origin] = 1;
    if (!face.is_turned && *corners == soup_.triangles[face.origin]) return;
    edits_.changed_faces.push_back(
        {.op = op_, .face = face.origin, .corners = {}, .turns_normals = face.is_turned});
    for (std::size_t k = 0; k < 3; ++k) {
      edits_.changed_faces.back().corners[k] = named((*corners)[k]);
    }
  }

  void add(const CombinedFace& face) {
    Triangle corners = face.corners;
    for (Index& v : corners) v = named(v);
    edits_.added_faces.push_back({.op = op_,
                                  .corners = corners,
                                  .prototype = is_of_source(face) ? face.origin : model_,
                                  .fills_hole = !is_of_source(face)});
  }

  /// Returns how the edits name a vertex of the result, and adds it if it is new.
  Index named(Index v) {
    const auto n_vertices = static_cast<Index>(soup_.n_vertices());
    if (v < n_vertices) return v;
    Index& number = added_[v - n_vertices];
    if (number == kNoIndex) {
      number = n_vertices + static_cast<Index>(edits_.added_vertices.size());
      edits_.added_vertices.push_back({.op = op_, .position = solid_.positions[v]});
    }
    return number;
  }

  void move_vertices() {
    for (Index v = 0; v < soup_.n_vertices(); ++v) {
      if (solid_.positions[v] == soup_.positions[v]) continue;
      edits_.moved_vertices.push_back({op_, v, solid_.positions[v]});
    }
  }

  /// Vertices that lose their last face are dropped without being named.
  void remove_orphans() {
    for (const Index v : find_orphan_vertices(soup_, {})) {
      edits_.removed_vertices.push_back({op_, v});
    }
  }

  const Soup& soup_;
  const CombinedSolid& solid_;
  std::vector<std::uint8_t> stays_;
  /// By added vertex: its number among those that are used.
  std::vector<Index> added_;
  Index model_ = 0;
  Index op_ = 0;
  Edits edits_;
};

/// Numbers the records 1, 2, ..., n where the format has numbers.
void number_from_one(TrackedMesh& mesh) {
  if (mesh.soup.format != Format::Mesh) return;
  mesh.soup.vertex_ids = {};
  mesh.soup.face_ids = {};
}

/// Converts keys of a second tracked mesh, which tracks the first one's soup, to keys of the first.
///
/// @param keys     By element of the soup of the first: its key there.
/// @param n_known  The number of keys that the first one has given.
Index outer_key(Index key, const std::vector<Index>& keys, std::size_t n_known) {
  return key < keys.size() ? keys[key] : static_cast<Index>(n_known + (key - keys.size()));
}

/// Makes a mesh track the input of the first one.
TrackedMesh composed(const TrackedMesh& first, TrackedMesh second) {
  for (Index& key : second.vertex_keys) {
    key = outer_key(key, first.vertex_keys, first.n_vertex_keys());
  }
  for (Index& key : second.face_keys) key = outer_key(key, first.face_keys, first.n_face_keys());
  std::vector<Index> vertex_origins = first.vertex_origins;
  for (const Index origin : second.vertex_origins) {
    vertex_origins.push_back(
        origin == kNoIndex ? kNoIndex : first.origin_of_vertex_key(first.vertex_keys[origin]));
  }
  std::vector<Index> face_origins = first.face_origins;
  for (const Index origin : second.face_origins) {
    face_origins.push_back(origin == kNoIndex ? kNoIndex : first.origin_of_face(origin));
  }
  second.vertex_origins = std::move(vertex_origins);
  second.face_origins = std::move(face_origins);
  second.n_input_vertices = first.n_input_vertices;
  second.n_input_faces = first.n_input_faces;
  return second;
}

bool is_manifold_and_outward(const Soup& soup) {
  const PreparedMesh mesh(soup);
  if (!mesh.cut().side.non_manifold_vertices.empty()) return false;
  const std::vector<Shell>& shells = mesh.shells();
  return std::all_of(shells.begin(), shells.end(),
                     [](const Shell& shell) { return shell.outward == true; });
}

MendedMesh mended(const TrackedMesh& combined, double max_deviation, RepairOptions options) {
  options.max_deviation = {max_deviation, Deviation::Unit::Length};
  RepairResult result = fix_defects(combined.soup, options);
  MendedMesh mesh{composed(combined, std::move(result.meshes.front().tracked)), true,
                  result.deviation};
  number_from_one(mesh.mesh);
  return mesh;
}

/// Subtracts others from a mesh, and parts surfaces of the result that touch.
/// @return The mesh as it was if the operation comes to no end.
MendedMesh subtracted_again(const MendedMesh& mended, const Soup& others,
                            const CombineOptions& options) {
  const std::vector<Soup> meshes{mended.mesh.soup, others};
  const Soup all = concatenate(meshes);
  const PartedDifference left = subtract_and_part(operands_of(all, meshes), others, options);
  if (left.solid.outcome != CombineOutcome::Done || left.solid.faces.empty()) return mended;
  TrackedMesh mesh = composed(mended.mesh, track_combined(mended.mesh.soup, left.solid));
  number_from_one(mesh);
  MendedMesh parted = part_combined(std::move(mesh), options.max_deviation);
  parted.is_mended = true;
  parted.largest_move += mended.largest_move + left.solid.largest_move;
  return parted;
}

}  // namespace

TrackedMesh track_combined(const Soup& source, const CombinedSolid& solid) {
  TrackedMesh tracked = track_mesh(source);
  tracked = apply_edits(tracked, CombinedEdits(source, solid).make());
  number_from_one(tracked);
  return tracked;
}

bool is_unchanged(const Soup& source, const CombinedSolid& solid) {
  if (solid.faces.size() != source.n_faces()) return false;
  // The faces are in order of their origins.
  for (Index f = 0; f < source.n_faces(); ++f) {
    const CombinedFace& face = solid.faces[f];
    if (face.origin != f || face.corners != source.triangles[f]) return false;
    for (const Index v : face.corners) {
      if (solid.positions[v] != source.positions[v]) return false;
    }
  }
  return true;
}

MendedMesh part_combined(TrackedMesh combined, double max_deviation) {
  require_length("the maximum deviation", max_deviation);
  if (is_manifold_and_outward(combined.soup)) return {std::move(combined)};
  RepairOptions options;
  options.fixes = {DefectCode::NonManifold, DefectCode::Inward};
  return mended(combined, max_deviation, std::move(options));
}

bool is_embedded(const Soup& soup) {
  const CutMesh cut = build(soup);
  return cut.side.non_manifold_vertices.empty() &&
         find_self_intersections(cut, FaceTree(cut)).empty();
}

MendedMesh mend_combined(const TrackedMesh& combined, const CombineOptions& options) {
  RepairOptions repair;
  repair.solid = true;
  repair.fill.sheets = FillSheets::Yes;
  repair.wants_to_stop = options.wants_to_stop;
  return mended(combined, options.max_deviation, std::move(repair));
}

MendedMesh keep_off(MendedMesh mended, const Soup& others, const CombineOptions& options) {
  require_length("the maximum deviation", options.max_deviation);
  const CutMesh cut_others = build(others);
  const FaceTree tree_of_others(cut_others);
  const auto n_pairs_of = [&](const Soup& soup) {
    const CutMesh cut = build(soup);
    const FaceTree tree(cut);
    return find_intersections(cut, tree, cut_others, tree_of_others).size() +
           find_self_intersections(cut, tree).size();
  };
  const double most = mended.largest_move + options.max_deviation;
  std::size_t n_left = n_pairs_of(mended.mesh.soup);
  for (int round = 0; round < kRoundsOfKeepingOff && n_left > 0; ++round) {
    MendedMesh next = subtracted_again(mended, others, options);
    const std::size_t n_next = n_pairs_of(next.mesh.soup);
    if (n_next >= n_left || next.largest_move > most) break;
    mended = std::move(next);
    n_left = n_next;
  }
  return mended;
}

}  // namespace meshalyzer
