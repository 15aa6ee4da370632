#include "meshalyzer/repair/edits/apply_edits.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/repair/edits/internal/edited_faces.h"
#include "meshalyzer/repair/edits/internal/edited_normals.h"
#include "meshalyzer/repair/edits/internal/fresh_ids.h"
#include "meshalyzer/repair/edits/internal/skipped_operations.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The edited mesh, and the faces after the edits.
struct Work {
  const TrackedMesh& tracked;
  const Edits& edits;
  const SkippedOperations& skipped;
  EditedFaces faces;
};

/// The new numbers of the vertices of a soup, and of those added to it.
struct VertexMoves {
  /// #old + #added vertices: the new index of each; kNoIndex for dropped ones.
  std::vector<Index> new_index;
  /// Indexed by new vertex: the old vertex that it is, or #old + the number of the added one.
  /// Ascending.
  std::vector<Index> sources;
};

/// Non-zero for each vertex that a face uses.
std::vector<std::uint8_t> used_vertices(std::span<const Triangle> triangles, std::size_t n) {
  std::vector<std::uint8_t> used(n, 0);
  for (const Triangle& triangle : triangles) {
    for (const Index v : triangle) {
      if (v != kNoIndex) used[v] = 1;
    }
  }
  return used;
}

/// Drops vertices that the edits list, and those that have lost their last face.
VertexMoves move_vertices(const Work& work) {
  const std::size_t n_old = work.tracked.soup.n_vertices();
  const std::size_t n = n_old + work.edits.added_vertices.size();
  const auto used_before = used_vertices(work.tracked.soup.triangles, n_old);
  const auto used_now = used_vertices(work.faces.triangles, n);
  std::vector<std::uint8_t> goes(n, 0);
  for (std::size_t v = 0; v < n; ++v) {
    goes[v] = used_now[v] == 0 && (v >= n_old || used_before[v] != 0) ? 1 : 0;
  }
  for (const Edits::RemovedVertex& removed : work.edits.removed_vertices) {
    if (!work.skipped(removed.op) && used_now[removed.vertex] == 0) goes[removed.vertex] = 1;
  }
  VertexMoves moves;
  moves.new_index.assign(n, kNoIndex);
  for (std::size_t v = 0; v < n; ++v) {
    if (goes[v] != 0) continue;
    moves.new_index[v] = static_cast<Index>(moves.sources.size());
    moves.sources.push_back(static_cast<Index>(v));
  }
  return moves;
}

std::vector<Vec3> edited_positions(const Work& work, const VertexMoves& moves) {
  std::vector<Vec3> positions;
  positions.reserve(moves.sources.size());
  for (const Index v : moves.sources) {
    positions.push_back(work.edits.position_of(work.tracked.soup, v));
  }
  for (const Edits::MovedVertex& moved : work.edits.moved_vertices) {
    const Index v = moves.new_index[moved.vertex];
    if (!work.skipped(moved.op) && v != kNoIndex) positions[v] = moved.to;
  }
  return positions;
}

void set_vertex_keys(const Work& work, const VertexMoves& moves, TrackedMesh& result) {
  const std::size_t n_old = work.tracked.soup.n_vertices();
  std::vector<std::uint8_t> is_sheet_cut(n_old + work.edits.added_vertices.size(), 0);
  for (const Edits::SheetCut& cut : work.edits.sheet_cuts) {
    if (!work.skipped(cut.op)) is_sheet_cut[cut.vertex] = 1;
  }
  result.vertex_origins = work.tracked.vertex_origins;
  result.sheet_cuts = work.tracked.sheet_cuts;
  result.vertex_keys.reserve(moves.sources.size());
  for (const Index v : moves.sources) {
    if (v < n_old) {
      result.vertex_keys.push_back(work.tracked.vertex_keys[v]);
    } else {
      const Index copy_of = work.edits.added_vertices[v - n_old].copy_of;
      Index origin = kNoIndex;
      if (copy_of != kNoIndex) {
        origin = work.tracked.origin_of_vertex_key(work.tracked.vertex_keys[copy_of]);
        // A copy of a vertex where a sheet was cut is another one.
        if (work.tracked.is_where_sheet_was_cut(copy_of)) is_sheet_cut[v] = 1;
      }
      result.vertex_keys.push_back(static_cast<Index>(result.n_vertex_keys()));
      result.vertex_origins.push_back(origin);
    }
    if (is_sheet_cut[v] != 0) result.sheet_cuts.push_back(result.vertex_keys.back());
  }
  sort_unique(result.sheet_cuts);
}

void set_face_keys(const Work& work, TrackedMesh& result) {
  const std::size_t n_old = work.tracked.soup.n_faces();
  // Keys follow the order of the edits, whatever groups the faces have joined.
  result.face_origins = work.tracked.face_origins;
  std::vector<Index> added_keys(work.edits.added_faces.size(), kNoIndex);
  for (std::size_t i = 0; i < work.edits.added_faces.size(); ++i) {
    const Edits::AddedFace& face = work.edits.added_faces[i];
    if (work.skipped(face.op)) continue;
    added_keys[i] = static_cast<Index>(result.n_face_keys());
    result.face_origins.push_back(face.fills_hole ? kNoIndex
                                                  : work.tracked.origin_of_face(face.prototype));
  }
  result.face_keys.reserve(work.faces.sources.size());
  for (const Index f : work.faces.sources) {
    result.face_keys.push_back(f < n_old ? work.tracked.face_keys[f] : added_keys[f - n_old]);
  }
}

void set_ids(const Work& work, const VertexMoves& moves, Soup& soup) {
  const Soup& old = work.tracked.soup;
  soup.vertex_ids = old.vertex_ids;
  soup.face_ids = old.face_ids;
  if (old.format != Format::Mesh) return;
  soup.vertex_ids = edit_ids(old.vertex_ids, {moves.sources, old.n_vertices()},
                             work.edits.changed_vertex_ids, work.skipped);
  soup.face_ids = edit_ids(old.face_ids, {work.faces.sources, old.n_faces()},
                           work.edits.changed_face_ids, work.skipped);
}

std::vector<MissingReference> remaining_missing(const Work& work) {
  std::vector<MissingReference> missing;
  for (MissingReference reference : work.tracked.soup.missing) {
    reference.face = work.faces.new_index[reference.face];
    if (reference.face != kNoIndex) missing.push_back(reference);
  }
  return missing;
}

}  // namespace

TrackedMesh apply_edits(const TrackedMesh& tracked, const Edits& edits,
                        std::span<const std::uint8_t> skipped) {
  const SkippedOperations is_skipped(skipped);
  Work work{tracked, edits, is_skipped, edit_faces(tracked.soup, edits, is_skipped)};
  const VertexMoves moves = move_vertices(work);

  TrackedMesh result;
  result.n_input_vertices = tracked.n_input_vertices;
  result.n_input_faces = tracked.n_input_faces;
  set_vertex_keys(work, moves, result);
  set_face_keys(work, result);
  Soup& soup = result.soup;
  soup.format = tracked.soup.format;
  soup.positions = edited_positions(work, moves);
  set_ids(work, moves, soup);
  soup.missing = remaining_missing(work);
  soup.triangles = work.faces.triangles;
  for (Triangle& triangle : soup.triangles) {
    for (Index& v : triangle) v = v == kNoIndex ? kNoIndex : moves.new_index[v];
  }
  soup.groups = std::move(work.faces.groups);
  set_edited_normals(tracked.soup, edits, is_skipped, work.faces, moves.sources, soup);
  return result;
}

}  // namespace meshalyzer
