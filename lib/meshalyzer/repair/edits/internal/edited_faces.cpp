#include "meshalyzer/repair/edits/internal/edited_faces.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

namespace meshalyzer {
namespace {

/// A run of consecutive old faces that belong to one group.
struct Run {
  Index group;
  Index begin;
  Index end;
};

std::vector<Run> runs_of(const Soup& soup) {
  std::vector<Run> runs;
  const auto n = static_cast<Index>(soup.n_faces());
  runs.push_back({kNoIndex, 0, soup.groups.empty() ? n : soup.groups.front().first_face});
  for (std::size_t g = 0; g < soup.groups.size(); ++g) {
    const Index end = g + 1 < soup.groups.size() ? soup.groups[g + 1].first_face : n;
    runs.push_back({static_cast<Index>(g), soup.groups[g].first_face, end});
  }
  return runs;
}

/// Returns the added faces that are not skipped, by run, in their order within each.
std::vector<std::pair<Index, Index>> added_by_run(const Soup& soup, const Edits& edits,
                                                  const SkippedOperations& skipped) {
  std::vector<std::pair<Index, Index>> added;
  for (std::size_t i = 0; i < edits.added_faces.size(); ++i) {
    if (skipped(edits.added_faces[i].op)) continue;
    const Index group = group_of(soup, edits.added_faces[i].prototype);
    // kNoIndex + 1 is 0: faces without a group belong to the first run.
    added.emplace_back(group + 1, static_cast<Index>(i));
  }
  std::sort(added.begin(), added.end());
  return added;
}

}  // namespace

EditedFaces edit_faces(const Soup& soup, const Edits& edits, const SkippedOperations& skipped) {
  const auto n_old = static_cast<Index>(soup.n_faces());
  std::vector<std::uint8_t> is_removed(n_old, 0);
  for (const Edits::RemovedFace& removed : edits.removed_faces) {
    if (!skipped(removed.op)) is_removed[removed.face] = 1;
  }
  std::vector<Triangle> old = soup.triangles;
  for (const Edits::ChangedFace& changed : edits.changed_faces) {
    if (!skipped(changed.op)) old[changed.face] = changed.corners;
  }
  const auto added = added_by_run(soup, edits, skipped);

  EditedFaces faces;
  faces.groups = soup.groups;
  faces.new_index.assign(n_old, kNoIndex);
  faces.triangles.reserve(n_old + added.size());
  faces.sources.reserve(n_old + added.size());
  auto next_added = added.begin();
  for (const Run& run : runs_of(soup)) {
    if (run.group != kNoIndex) {
      faces.groups[run.group].first_face = static_cast<Index>(faces.triangles.size());
    }
    for (Index f = run.begin; f < run.end; ++f) {
      if (is_removed[f]) continue;
      faces.new_index[f] = static_cast<Index>(faces.triangles.size());
      faces.sources.push_back(f);
      faces.triangles.push_back(old[f]);
    }
    for (; next_added != added.end() && next_added->first == run.group + 1; ++next_added) {
      faces.sources.push_back(n_old + next_added->second);
      faces.triangles.push_back(edits.added_faces[next_added->second].corners);
    }
  }
  return faces;
}

}  // namespace meshalyzer
