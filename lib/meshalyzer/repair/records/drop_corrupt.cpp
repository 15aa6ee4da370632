#include "meshalyzer/mesh/repeated_ids.h"
#include "meshalyzer/repair/edits/internal/fresh_ids.h"
#include "meshalyzer/repair/passes.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {
namespace {

void drop_incomplete_faces(const Soup& soup, Edits& edits) {
  std::vector<Index> incomplete;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    if (!has_all_corners(soup.triangles[f])) incomplete.push_back(f);
  }
  if (incomplete.empty()) return;
  const Index op = edits.begin_operation();
  for (const Index f : incomplete) edits.removed_faces.push_back({op, f});
}

/// Nothing refers to a record that repeats the id of an earlier one.
void drop_repeated_vertices(const Soup& soup, Edits& edits) {
  const std::vector<Index> repeated = find_repeated_ids(soup.vertex_ids);
  if (repeated.empty()) return;
  const Index op = edits.begin_operation();
  for (const Index v : repeated) edits.removed_vertices.push_back({op, v});
}

void rename_repeated_faces(const Soup& soup, Edits& edits) {
  std::vector<Index> repeated = find_repeated_ids(soup.face_ids);
  std::erase_if(repeated, [&](Index f) { return !has_all_corners(soup.triangles[f]); });
  if (repeated.empty()) return;
  const Index op = edits.begin_operation();
  const std::vector<std::int32_t> ids = fresh_ids(soup.face_ids.named, repeated.size());
  for (std::size_t i = 0; i < repeated.size(); ++i) {
    edits.changed_face_ids.push_back({op, repeated[i], ids[i]});
  }
}

}  // namespace

PassResult drop_corrupt(const PassInput& input) {
  const Soup& soup = input.tracked.soup;
  PassResult result;
  drop_incomplete_faces(soup, result.edits);
  drop_repeated_vertices(soup, result.edits);
  rename_repeated_faces(soup, result.edits);
  // No record exists for a torn line, so that it is missing from any file written.
  if (!soup.torn_lines.empty()) static_cast<void>(result.edits.begin_operation());
  return result;
}

}  // namespace meshalyzer
