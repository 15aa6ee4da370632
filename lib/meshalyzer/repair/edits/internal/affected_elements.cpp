#include "meshalyzer/repair/edits/internal/affected_elements.h"

#include "meshalyzer/base/sort_unique.h"

#include <algorithm>

namespace meshalyzer {
namespace {

/// Maps each vertex to the operation that moves it.
std::vector<Index> movers(const TrackedMesh& before, const Edits& edits,
                          const SkippedOperations& skipped) {
  std::vector<Index> mover;
  for (const Edits::MovedVertex& moved : edits.moved_vertices) {
    if (skipped(moved.op)) continue;
    mover.resize(before.soup.n_vertices(), kNoIndex);
    mover[moved.vertex] = moved.op;
  }
  return mover;
}

void add_moved_faces(const TrackedMesh& before, const std::vector<Index>& mover,
                     AffectedElements& affected) {
  if (mover.empty()) return;
  for (std::size_t f = 0; f < before.soup.n_faces(); ++f) {
    for (const Index v : before.soup.triangles[f]) {
      if (v == kNoIndex || mover[v] == kNoIndex) continue;
      affected.faces_before.push_back({before.face_keys[f], mover[v]});
      affected.faces_after.push_back({before.face_keys[f], mover[v]});
    }
  }
}

void add_edited_faces(const TrackedMesh& before, const Edits& edits,
                      const SkippedOperations& skipped, AffectedElements& affected) {
  for (const Edits::RemovedFace& removed : edits.removed_faces) {
    if (skipped(removed.op)) continue;
    affected.faces_before.push_back({before.face_keys[removed.face], removed.op});
  }
  for (const Edits::ChangedFace& changed : edits.changed_faces) {
    if (skipped(changed.op)) continue;
    const AffectedElement entry{before.face_keys[changed.face], changed.op};
    affected.faces_before.push_back(entry);
    affected.faces_after.push_back(entry);
  }
  auto next_key = static_cast<Index>(before.n_face_keys());
  for (const Edits::AddedFace& added : edits.added_faces) {
    if (!skipped(added.op)) affected.faces_after.push_back({next_key++, added.op});
  }
}

/// Adds the corners of the affected faces.
void add_corners(const TrackedMesh& tracked, const std::vector<AffectedElement>& faces,
                 std::vector<AffectedElement>& vertices) {
  if (faces.empty()) return;
  for (std::size_t f = 0; f < tracked.soup.n_faces(); ++f) {
    for (const AffectedElement& entry : operations_on(faces, tracked.face_keys[f])) {
      for (const Index v : tracked.soup.triangles[f]) {
        if (v != kNoIndex) vertices.push_back({tracked.vertex_keys[v], entry.operation});
      }
    }
  }
}

}  // namespace

std::span<const AffectedElement> operations_on(const std::vector<AffectedElement>& entries,
                                               Index key) {
  const auto begin = std::lower_bound(entries.begin(), entries.end(), AffectedElement{key, 0});
  auto end = begin;
  while (end != entries.end() && end->key == key) ++end;
  return {begin, end};
}

AffectedElements find_affected_elements(const TrackedMesh& before, const Edits& edits,
                                        const SkippedOperations& skipped,
                                        const TrackedMesh& after) {
  AffectedElements affected;
  add_edited_faces(before, edits, skipped, affected);
  add_moved_faces(before, movers(before, edits, skipped), affected);
  sort_unique(affected.faces_before);
  sort_unique(affected.faces_after);
  // A face that was moved and removed is part of the mesh before only.
  add_corners(before, affected.faces_before, affected.vertices);
  add_corners(after, affected.faces_after, affected.vertices);
  sort_unique(affected.vertices);
  return affected;
}

}  // namespace meshalyzer
