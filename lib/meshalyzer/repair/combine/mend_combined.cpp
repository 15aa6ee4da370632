#include "meshalyzer/repair/combine/mend_combined.h"

#include "meshalyzer/base/require.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/boolean/make_disjoint.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/combine/internal/number_from_one.h"
#include "meshalyzer/repair/combine/track_combined.h"
#include "meshalyzer/repair/fix_defects.h"
#include "meshalyzer/spatial/mutual_intersection.h"
#include "meshalyzer/spatial/self_intersection.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// How often a difference is subtracted again where it still meets the others. Most that are parted
/// at all are so after one or two rounds.
constexpr int kRoundsOfKeepingOff = 3;

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
  for (Index& key : second.sheet_cuts) {
    key = outer_key(key, first.vertex_keys, first.n_vertex_keys());
  }
  second.sheet_cuts.insert(second.sheet_cuts.end(), first.sheet_cuts.begin(),
                           first.sheet_cuts.end());
  sort_unique(second.sheet_cuts);
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

/// Tells whether a mesh is manifold, and no faces of it intersect.
bool is_embedded(const Soup& soup) {
  const CutMesh cut = build(soup);
  return cut.side.non_manifold_vertices.empty() &&
         find_self_intersections(cut, FaceTree(cut)).empty();
}

/// Returns the second result, with what was done to make the first, which it was made of.
MendedMesh after(const MendedMesh& first, MendedMesh second) {
  second.is_parted = second.is_parted || first.is_parted;
  second.is_oriented = second.is_oriented || first.is_oriented;
  second.is_repaired = second.is_repaired || first.is_repaired;
  second.is_subtracted_again = second.is_subtracted_again || first.is_subtracted_again;
  second.largest_move += first.largest_move;
  return second;
}

MendedMesh repaired(const TrackedMesh& combined, double max_deviation, RepairOptions options) {
  options.max_deviation = {max_deviation, Deviation::Unit::Length};
  RepairResult result = fix_defects(combined.soup, options);
  TrackedMesh mesh = composed(combined, std::move(result.meshes.front().tracked));
  number_from_one(mesh);
  return {.mesh = std::move(mesh), .largest_move = result.deviation};
}

/// Parts surfaces that touch, as a repair of `non-manifold` does, and orients them outwards.
MendedMesh parted(TrackedMesh combined, double max_deviation) {
  if (is_manifold_and_outward(combined.soup)) return {.mesh = std::move(combined)};
  RepairOptions options;
  options.fixes = {DefectCode::NonManifold, DefectCode::Inward};
  MendedMesh mended = repaired(combined, max_deviation, std::move(options));
  mended.is_parted = mended.largest_move > 0.0;
  mended.is_oriented = !mended.is_parted;
  return mended;
}

MendedMesh repair_as_solid(const TrackedMesh& combined, const CombineOptions& options) {
  RepairOptions repair;
  repair.solid = true;
  repair.fill.sheets = FillSheets::Yes;
  repair.wants_to_stop = options.wants_to_stop;
  MendedMesh mended = repaired(combined, options.max_deviation, std::move(repair));
  mended.is_repaired = true;
  return mended;
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
  MendedMesh result = parted(std::move(mesh), options.max_deviation);
  result.is_subtracted_again = true;
  result.largest_move += left.solid.largest_move;
  return after(mended, std::move(result));
}

}  // namespace

MendedMesh mend_combined(TrackedMesh combined, CombineOutcome outcome, bool is_moved,
                         const CombineOptions& options) {
  require_length("the maximum deviation", options.max_deviation);
  if (outcome == CombineOutcome::Unfinished) return repair_as_solid(combined, options);
  MendedMesh result = parted(std::move(combined), options.max_deviation);
  const bool may_intersect = is_moved || result.is_mended();
  if (!may_intersect || is_embedded(result.mesh.soup)) return result;
  return after(result, repair_as_solid(result.mesh, options));
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
