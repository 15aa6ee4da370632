#include "meshalyzer/analysis/internal/integrity.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/mesh/numbering.h"
#include "meshalyzer/mesh/orphans.h"
#include "meshalyzer/mesh/repeated_ids.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

namespace meshalyzer {
namespace {

/// Tells whether a face names one vertex more than once; vertices that no record defines are
/// compared by id.
bool names_a_vertex_twice(const Triangle& t, const std::array<std::int64_t, 3>& missing) {
  const auto same = [&](std::size_t i, std::size_t j) {
    return t[i] == t[j] && (t[i] != kNoIndex || missing[i] == missing[j]);
  };
  return same(0, 1) || same(1, 2) || same(2, 0);
}

void find_broken_faces(const Soup& soup, Offenders& offenders) {
  auto reference = soup.missing.begin();
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    std::array<std::int64_t, 3> missing{-1, -1, -1};
    bool has_missing = false;
    for (; reference != soup.missing.end() && reference->face == f; ++reference) {
      missing[reference->corner] = reference->id;
      has_missing = true;
    }
    if (has_missing) {
      offenders.faces_with_missing_vertices.push_back(static_cast<Index>(f));
    }
    if (names_a_vertex_twice(soup.triangles[f], missing)) {
      offenders.degenerate_faces.push_back(static_cast<Index>(f));
    }
  }
}

std::vector<std::int64_t> distinct_missing_ids(const Soup& soup) {
  std::vector<std::int64_t> ids;
  ids.reserve(soup.missing.size());
  for (const MissingReference& reference : soup.missing) {
    ids.push_back(reference.id);
  }
  sort_unique(ids);
  return ids;
}

/// Describes where the ids of `n` records cease to be 1, 2, ..., n, if they do.
std::optional<NumberingBreak> find_break(const Ids& ids, Format format, std::size_t n) {
  const std::optional<Index> offender = first_misnumbered(ids, format, n);
  if (!offender) return std::nullopt;
  NumberingBreak found;
  const Index first = *offender < 2 ? 0 : *offender - 2;
  for (Index k = first; k < std::min<std::size_t>(n, std::size_t{*offender} + 3); ++k) {
    found.ids.push_back(ids.of(k));
  }
  found.offender = *offender - first;
  return found;
}

}  // namespace

Integrity check_integrity(const Soup& soup, Offenders& offenders) {
  find_broken_faces(soup, offenders);
  offenders.missing_vertices = distinct_missing_ids(soup);
  offenders.duplicate_vertex_records = find_repeated_ids(soup.vertex_ids);
  offenders.orphan_vertices = find_orphan_vertices(soup, offenders.duplicate_vertex_records);
  offenders.duplicate_face_records = find_repeated_ids(soup.face_ids);
  offenders.torn_lines.assign(soup.torn_lines.begin(), soup.torn_lines.end());
  offenders.vertex_numbering = find_break(soup.vertex_ids, soup.format, soup.n_vertices());
  offenders.face_numbering = find_break(soup.face_ids, soup.format, soup.n_faces());
  return {.orphan_vertices = offenders.orphan_vertices.size(),
          .missing_vertices = offenders.missing_vertices.size(),
          .degenerate_faces = offenders.degenerate_faces.size(),
          .duplicate_vertex_indices = offenders.duplicate_vertex_records.size(),
          .duplicate_face_indices = offenders.duplicate_face_records.size(),
          .torn_lines = offenders.torn_lines.size(),
          .contiguous_vertices = !offenders.vertex_numbering.has_value(),
          .contiguous_faces = !offenders.face_numbering.has_value()};
}

}  // namespace meshalyzer
