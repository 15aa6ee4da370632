#include "meshalyzer/mesh/repeated_ids.h"
#include "meshalyzer/repair/passes.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <unordered_set>
#include <vector>

namespace meshalyzer {
namespace {

/// Ids that no record has.
class UnusedIds {
 public:
  explicit UnusedIds(const std::vector<std::int32_t>& used)
      : used_(used.begin(), used.end()),
        last_(used.empty() ? 0 : *std::max_element(used.begin(), used.end())) {}

  /// The one after the largest; where there is none, the smallest from 1 on that is free.
  [[nodiscard]] std::int32_t next() {
    if (last_ < std::numeric_limits<std::int32_t>::max()) return ++last_;
    while (used_.contains(smallest_)) ++smallest_;
    return smallest_++;
  }

 private:
  std::unordered_set<std::int32_t> used_;
  std::int32_t last_;
  std::int32_t smallest_ = 1;
};

bool has_missing_corner(const Triangle& t) {
  return std::find(t.begin(), t.end(), kNoIndex) != t.end();
}

void drop_incomplete_faces(const Soup& soup, Edits& edits) {
  std::vector<Index> incomplete;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    if (has_missing_corner(soup.triangles[f])) incomplete.push_back(f);
  }
  if (incomplete.empty()) return;
  const Index op = edits.begin_operation();
  for (const Index f : incomplete) edits.removed_faces.push_back({op, f});
}

/// Nothing refers to a record whose id an earlier one has.
void drop_repeated_vertices(const Soup& soup, Edits& edits) {
  const std::vector<Index> repeated = find_repeated_ids(soup.vertex_ids);
  if (repeated.empty()) return;
  const Index op = edits.begin_operation();
  for (const Index v : repeated) edits.removed_vertices.push_back({op, v});
}

void rename_repeated_faces(const Soup& soup, Edits& edits) {
  std::vector<Index> repeated = find_repeated_ids(soup.face_ids);
  std::erase_if(repeated, [&](Index f) { return has_missing_corner(soup.triangles[f]); });
  if (repeated.empty()) return;
  const Index op = edits.begin_operation();
  UnusedIds ids(soup.face_ids.named);
  for (const Index f : repeated) edits.changed_face_ids.push_back({op, f, ids.next()});
}

}  // namespace

PassResult drop_corrupt(const PassInput& input) {
  const Soup& soup = input.draft.soup;
  PassResult result;
  drop_incomplete_faces(soup, result.edits);
  drop_repeated_vertices(soup, result.edits);
  rename_repeated_faces(soup, result.edits);
  // No record is left of a torn line: whatever is written next is without it.
  if (!soup.torn_lines.empty()) static_cast<void>(result.edits.begin_operation());
  return result;
}

}  // namespace meshalyzer
