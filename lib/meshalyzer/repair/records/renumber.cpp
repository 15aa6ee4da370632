#include "meshalyzer/repair/passes.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {
namespace {

/// Returns the records whose id is not their position in the file, counted from 1.
std::vector<Edits::ChangedId> wanted_changes(const Ids& ids, std::size_t n) {
  std::vector<Edits::ChangedId> changes;
  for (Index record = 0; record < n; ++record) {
    const std::int64_t wanted = std::int64_t{record} + 1;
    if (ids.of(record) != wanted) {
      changes.push_back({0, record, static_cast<std::int32_t>(wanted)});
    }
  }
  return changes;
}

}  // namespace

PassResult renumber(const PassInput& input) {
  const Soup& soup = input.tracked.soup;
  PassResult result;
  // The other formats number their records implicitly.
  if (soup.format != Format::Mesh) return result;
  Edits& edits = result.edits;
  if (soup.missing.empty()) {
    edits.changed_vertex_ids = wanted_changes(soup.vertex_ids, soup.n_vertices());
  } else {
    result.refused.push_back({DefectCode::Numbering, kNoIndex, soup.missing.front().face,
                              "it names a vertex that does not exist, and would name another one "
                              "if the vertices were numbered anew"});
  }
  edits.changed_face_ids = wanted_changes(soup.face_ids, soup.n_faces());
  if (!edits.changed_vertex_ids.empty() || !edits.changed_face_ids.empty()) {
    static_cast<void>(edits.begin_operation());
  }
  return result;
}

}  // namespace meshalyzer
