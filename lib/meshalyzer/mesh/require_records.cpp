#include "meshalyzer/mesh/require_records.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {
namespace {

/// @param named  What the corners name: "vertex".
/// @param n      How many of these there are.
void require_corners(const std::vector<Triangle>& corners, std::string_view named, std::size_t n) {
  const auto is_outside = [&](Index i) { return i >= n && i != kNoIndex; };
  const std::vector<Index> wrong = parallel_filter(
      corners.size(), [&](Index face) { return std::ranges::any_of(corners[face], is_outside); });
  if (wrong.empty()) return;
  const Triangle& t = corners[wrong.front()];
  throw InvalidArgument("face " + std::to_string(wrong.front()) + " names " + std::string(named) +
                        " " + std::to_string(*std::ranges::find_if(t, is_outside)) + " of " +
                        std::to_string(n));
}

/// A list with an entry for each record, unless it is empty.
struct RecordColumn {
  std::string_view name;
  std::size_t size;
  std::size_t n_records;
};

void require_lengths(const Soup& soup) {
  const std::size_t n_vertices = soup.n_vertices();
  const std::size_t n_faces = soup.n_faces();
  for (const RecordColumn& column :
       {RecordColumn{"ids of vertices", soup.vertex_ids.named.size(), n_vertices},
        RecordColumn{"ids of faces", soup.face_ids.named.size(), n_faces},
        RecordColumn{"lines of vertices", soup.vertex_lines.size(), n_vertices},
        RecordColumn{"lines of faces", soup.face_lines.size(), n_faces},
        RecordColumn{"normals of corners of faces", soup.corner_normals.size(), n_faces}}) {
    // What is left over of records that were dropped does no harm.
    if (column.size == 0 || column.size >= column.n_records) continue;
    throw InvalidArgument("a soup has " + std::to_string(column.size) + " " +
                          std::string(column.name) + " for " + std::to_string(column.n_records));
  }
}

void require_references(const Soup& soup) {
  const auto is_after = [](const Group& a, const Group& b) { return a.first_face > b.first_face; };
  if (std::ranges::adjacent_find(soup.groups, is_after) != soup.groups.end()) {
    throw InvalidArgument("the groups of a soup are not in the order of their faces");
  }
  if (!soup.groups.empty() && soup.groups.back().first_face > soup.n_faces()) {
    throw InvalidArgument("a group of a soup begins at face " +
                          std::to_string(soup.groups.back().first_face) + " of " +
                          std::to_string(soup.n_faces()));
  }
  if (std::ranges::any_of(soup.missing, [&](const MissingReference& missing) {
        return missing.face >= soup.n_faces() || missing.corner > 2;
      })) {
    throw InvalidArgument("a missing reference of a soup is at no corner of a face");
  }
}

}  // namespace

void require_records(const Soup& soup) {
  require_corners(soup.triangles, "vertex", soup.n_vertices());
  require_lengths(soup);
  require_corners(soup.corner_normals, "normal", soup.normals.size());
  require_references(soup);
}

}  // namespace meshalyzer
