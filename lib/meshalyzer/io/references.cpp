#include "meshalyzer/io/references.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/parallel_sort.h"
#include "meshalyzer/mesh/repeated_ids.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

/// Consecutive ids in order, the common case, which needs no table.
struct ContiguousIds {
  Index first;
  Index n;
  [[nodiscard]] Index record(Index id) const {
    return id >= first && id - first < n ? id - first : kNoIndex;
  }
};

/// One entry for each id from 0 to the largest.
struct DenseIds {
  explicit DenseIds(const std::vector<std::int32_t>& ids, std::size_t largest)
      : records(largest + 1, kNoIndex) {
    for (std::size_t i = ids.size(); i-- > 0;) {
      records[static_cast<std::size_t>(ids[i])] = static_cast<Index>(i);
    }
  }
  [[nodiscard]] Index record(Index id) const {
    return id < records.size() ? records[id] : kNoIndex;
  }
  std::vector<Index> records;
};

/// Sorted pairs (id, record) in one 64-bit key each, so that memory does not depend on the size of
/// the ids.
struct SparseIds {
  explicit SparseIds(const std::vector<std::int32_t>& ids) : keys(ids.size()) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      keys[i] = static_cast<std::uint64_t>(ids[i]) << 32U | i;
    }
    parallel_sort(keys);
  }
  [[nodiscard]] Index record(Index id) const {
    const auto found = std::lower_bound(keys.begin(), keys.end(), std::uint64_t{id} << 32U);
    return found != keys.end() && *found >> 32U == id ? static_cast<Index>(*found & 0xFFFFFFFFU)
                                                      : kNoIndex;
  }
  std::vector<std::uint64_t> keys;
};

/// Replaces each corner c by record_of(c); if that is kNoIndex, stores id_of(c) as a missing
/// reference.
template <typename RecordOf, typename IdOf>
void replace_corners(Soup& soup, RecordOf record_of, IdOf id_of) {
  using Missing = std::vector<MissingReference>;
  const auto parts = map_chunks<Missing>(soup.triangles.size(), [&](Chunk chunk) {
    Missing missing;
    for (std::size_t f = chunk.begin; f < chunk.end; ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        Index& corner = soup.triangles[f][k];
        const Index named = std::exchange(corner, record_of(corner));
        if (corner == kNoIndex) {
          missing.push_back({static_cast<Index>(f), static_cast<std::uint8_t>(k), id_of(named)});
        }
      }
    }
    return missing;
  });
  for (const Missing& part : parts) {
    soup.missing.insert(soup.missing.end(), part.begin(), part.end());
  }
}

template <typename Table>
void replace_ids(Soup& soup, const Table& table) {
  replace_corners(
      soup, [&](Index id) { return table.record(id); }, [](Index id) { return std::int64_t{id}; });
}

}  // namespace

Ids compact_ids(std::vector<std::int32_t> ids) {
  if (ids.empty()) {
    return {};
  }
  const std::int32_t first = ids.front();
  std::size_t n = 1;
  while (n < ids.size() && ids[n] == first + static_cast<std::int64_t>(n)) {
    ++n;
  }
  if (n == ids.size()) {
    return {.first = first, .named = {}};
  }
  return {.first = first, .named = std::move(ids)};
}

void resolve_ids(Soup& soup) {
  const std::vector<std::int32_t>& ids = soup.vertex_ids.named;
  if (ids.empty()) {
    replace_ids(soup, ContiguousIds{static_cast<Index>(soup.vertex_ids.first),
                                    static_cast<Index>(soup.n_vertices())});
    return;
  }
  // This takes at most twice the memory of the sorted keys, and is much faster.
  const auto largest = static_cast<std::size_t>(*std::max_element(ids.begin(), ids.end()));
  if (largest / 4 <= ids.size()) {
    replace_ids(soup, DenseIds(ids, largest));
  } else {
    replace_ids(soup, SparseIds(ids));
  }
}

void resolve_indices(Soup& soup) {
  const std::size_t n = soup.n_vertices();
  replace_corners(
      soup, [n](Index index) { return index < n ? index : kNoIndex; },
      [first = soup.vertex_ids.first](Index index) { return std::int64_t{first} + index; });
}

void append_fan(std::vector<Triangle>& triangles, const std::vector<Index>& corners) {
  const std::size_t last = corners.size() - 1;
  std::size_t i = 0;
  do {
    triangles.push_back(
        {corners[0], corners[std::min(i + 1, last)], corners[std::min(i + 2, last)]});
    ++i;
  } while (i + 2 <= last);
}

void append_polygon(Soup& soup, const std::vector<Index>& corners, std::size_t line) {
  append_fan(soup.triangles, corners);
  soup.n_polygons += corners.size() > 3 ? 1 : 0;
  if (line != 0) {
    soup.face_lines.resize(soup.n_faces(), static_cast<std::uint32_t>(line));
  }
}

bool has_vertex_normals(const Soup& soup) {
  return !soup.normals.empty() && soup.normals.size() == soup.n_vertices() &&
         soup.corner_normals == soup.triangles;
}

void use_vertex_normals(Soup& soup) {
  if (!soup.normals.empty()) {
    soup.corner_normals = soup.triangles;
  }
}

void require_all_vertices(const Soup& soup) {
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    for (const Index corner : soup.triangles[f]) {
      if (corner >= soup.n_vertices()) {
        throw InvalidArgument("face " + std::to_string(soup.face_ids.of(static_cast<Index>(f))) +
                              " has a corner without a vertex: it cannot be written");
      }
    }
  }
}

void require_unambiguous_ids(const Soup& soup) {
  const std::vector<Index> repeated = find_repeated_ids(soup.vertex_ids);
  if (repeated.empty()) return;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    for (const Index v : soup.triangles[f]) {
      if (std::binary_search(repeated.begin(), repeated.end(), v)) {
        throw InvalidArgument("face " + std::to_string(soup.face_ids.of(f)) +
                              " has a vertex whose id " + std::to_string(soup.vertex_ids.of(v)) +
                              " belongs to an earlier one: it cannot be written");
      }
    }
  }
}

}  // namespace meshalyzer
