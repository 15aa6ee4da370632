#include "meshalyzer/repair/edits/touched.h"

#include "meshalyzer/repair/sort_unique.h"

#include <algorithm>

namespace meshalyzer {
namespace {

/// By vertex: the operation that moves it.
std::vector<Index> movers(const Draft& before, const Edits& edits,
                          const SkippedOperations& skipped) {
  std::vector<Index> mover;
  for (const Edits::MovedVertex& moved : edits.moved_vertices) {
    if (skipped(moved.op)) continue;
    mover.resize(before.soup.n_vertices(), kNoIndex);
    mover[moved.vertex] = moved.op;
  }
  return mover;
}

void touch_moved_faces(const Draft& before, const std::vector<Index>& mover, Touched& touched) {
  if (mover.empty()) return;
  for (std::size_t f = 0; f < before.soup.n_faces(); ++f) {
    for (const Index v : before.soup.triangles[f]) {
      if (v == kNoIndex || mover[v] == kNoIndex) continue;
      touched.faces_before.push_back({before.face_keys[f], mover[v]});
      touched.faces_after.push_back({before.face_keys[f], mover[v]});
    }
  }
}

void touch_edited_faces(const Draft& before, const Edits& edits, const SkippedOperations& skipped,
                        Touched& touched) {
  for (const Edits::RemovedFace& removed : edits.removed_faces) {
    if (skipped(removed.op)) continue;
    touched.faces_before.push_back({before.face_keys[removed.face], removed.op});
  }
  for (const Edits::ChangedFace& changed : edits.changed_faces) {
    if (skipped(changed.op)) continue;
    const Touch touch{before.face_keys[changed.face], changed.op};
    touched.faces_before.push_back(touch);
    touched.faces_after.push_back(touch);
  }
  auto next_key = static_cast<Index>(before.n_input_faces + before.face_origins.size());
  for (const Edits::AddedFace& added : edits.added_faces) {
    if (!skipped(added.op)) touched.faces_after.push_back({next_key++, added.op});
  }
}

/// Touches the corners of the faces that are touched.
void touch_corners(const Draft& draft, const std::vector<Touch>& faces,
                   std::vector<Touch>& vertices) {
  if (faces.empty()) return;
  for (std::size_t f = 0; f < draft.soup.n_faces(); ++f) {
    for (const Touch& touch : touching(faces, draft.face_keys[f])) {
      for (const Index v : draft.soup.triangles[f]) {
        if (v != kNoIndex) vertices.push_back({draft.vertex_keys[v], touch.operation});
      }
    }
  }
}

}  // namespace

std::span<const Touch> touching(const std::vector<Touch>& touches, Index key) {
  const auto begin = std::lower_bound(touches.begin(), touches.end(), Touch{key, 0});
  auto end = begin;
  while (end != touches.end() && end->key == key) ++end;
  return {begin, end};
}

Touched find_touched(const Draft& before, const Edits& edits, const SkippedOperations& skipped,
                     const Draft& after) {
  Touched touched;
  touch_edited_faces(before, edits, skipped, touched);
  touch_moved_faces(before, movers(before, edits, skipped), touched);
  sort_unique(touched.faces_before);
  sort_unique(touched.faces_after);
  // A face that was moved and removed is of the draft before alone.
  touch_corners(before, touched.faces_before, touched.vertices);
  touch_corners(after, touched.faces_after, touched.vertices);
  sort_unique(touched.vertices);
  return touched;
}

}  // namespace meshalyzer
