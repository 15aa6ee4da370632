#include "meshalyzer/repair/records/separate.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/io/references.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>

namespace meshalyzer {
namespace {

/// The part that each element goes to, with the parts in their final order.
struct Parts {
  std::size_t count = 0;
  /// #F: the part of each face.
  std::vector<Index> of_face;
};

/// Returns, by vertex, the lowest vertex of its component; the vertex itself if it is in none.
DisjointSets join_vertices(const Soup& soup) {
  DisjointSets vertices(soup.n_vertices());
  for (const Triangle& t : soup.triangles) {
    if (!is_in_complex(t)) continue;
    vertices.unite(t[0], t[1]);
    vertices.unite(t[0], t[2]);
  }
  return vertices;
}

/// Numbers the components in order of their lowest face, by face; kNoIndex for faces in none.
Parts number_components(const Soup& soup) {
  DisjointSets vertices = join_vertices(soup);
  std::vector<Index> number(soup.n_vertices(), kNoIndex);
  Parts parts;
  parts.of_face.assign(soup.n_faces(), kNoIndex);
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    const Triangle& t = soup.triangles[f];
    if (!is_in_complex(t)) continue;
    Index& part = number[vertices.find(t[0])];
    if (part == kNoIndex) part = static_cast<Index>(parts.count++);
    parts.of_face[f] = part;
  }
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    for (const Index v : soup.triangles[f]) {
      if (parts.of_face[f] == kNoIndex && v != kNoIndex) {
        parts.of_face[f] = number[vertices.find(v)];
      }
    }
  }
  return parts;
}

/// Numbers the parts anew, the largest first, and assigns elements in none to the first.
void sort_by_size(const Soup& soup, Parts& parts) {
  std::vector<std::size_t> n_faces(parts.count);
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    if (is_in_complex(soup.triangles[f])) ++n_faces[parts.of_face[f]];
  }
  std::vector<Index> order(parts.count);
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return n_faces[a] > n_faces[b]; });
  std::vector<Index> rank(parts.count);
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<Index>(i);
  for (Index& part : parts.of_face) part = part == kNoIndex ? 0 : rank[part];
}

/// Returns the faces of each part, ascending.
std::vector<std::vector<Index>> faces_by_part(const Parts& parts) {
  std::vector<std::vector<Index>> faces(parts.count);
  for (std::size_t f = 0; f < parts.of_face.size(); ++f) {
    faces[parts.of_face[f]].push_back(static_cast<Index>(f));
  }
  return faces;
}

/// Returns the records that these lists name, ascending, each once.
std::vector<Index> used_by(std::span<const Triangle> lists, std::span<const Index> faces) {
  std::vector<Index> used;
  for (const Index f : faces) {
    for (const Index i : lists[f]) {
      if (i != kNoIndex) used.push_back(i);
    }
  }
  sort_unique(used);
  return used;
}

/// Returns the records that no list names, ascending.
std::vector<Index> unused_by(std::span<const Triangle> lists, std::size_t n_records) {
  std::vector<std::uint8_t> is_used(n_records);
  for (const Triangle& list : lists) {
    for (const Index i : list) {
      if (i != kNoIndex) is_used[i] = 1;
    }
  }
  std::vector<Index> unused;
  for (std::size_t i = 0; i < n_records; ++i) {
    if (is_used[i] == 0) unused.push_back(static_cast<Index>(i));
  }
  return unused;
}

/// Returns the elements of a list at the given indices.
template <typename T>
std::vector<T> picked(const std::vector<T>& all, std::span<const Index> wanted) {
  std::vector<T> some;
  some.reserve(wanted.size());
  for (const Index i : wanted) some.push_back(all[i]);
  return some;
}

/// Returns the origins up to that of the last added element, if any was added.
std::vector<Index> origins_for(const std::vector<Index>& keys, std::size_t n_input,
                               const std::vector<Index>& origins) {
  const Index last = keys.empty() ? 0 : *std::max_element(keys.begin(), keys.end());
  const std::size_t n = last < n_input ? 0 : last + 1 - n_input;
  return {origins.begin(), origins.begin() + static_cast<std::ptrdiff_t>(n)};
}

/// Extracts parts of a tracked mesh.
class Extractor {
 public:
  explicit Extractor(const TrackedMesh& tracked)
      : tracked_(tracked),
        soup_(tracked.soup),
        new_vertex_(soup_.n_vertices()),
        new_normal_(soup_.normals.size()),
        has_vertex_normals_(has_vertex_normals(soup_)) {}

  /// The treatment of records that nothing uses.
  enum class Rest { Takes, Leaves };
  TrackedMesh extract(std::span<const Index> faces, Rest rest) {
    const std::vector<Index> vertices = records(soup_.triangles, faces, rest, soup_.n_vertices());
    number(vertices, new_vertex_);
    TrackedMesh part;
    part.n_input_vertices = tracked_.n_input_vertices;
    part.n_input_faces = tracked_.n_input_faces;
    part.vertex_keys = picked(tracked_.vertex_keys, vertices);
    part.face_keys = picked(tracked_.face_keys, faces);
    part.vertex_origins =
        origins_for(part.vertex_keys, tracked_.n_input_vertices, tracked_.vertex_origins);
    part.face_origins = origins_for(part.face_keys, tracked_.n_input_faces, tracked_.face_origins);
    part.sheet_cuts = tracked_.sheet_cuts;
    part.soup.format = soup_.format;
    part.soup.positions = picked(soup_.positions, vertices);
    part.soup.triangles = renumbered(picked(soup_.triangles, faces), new_vertex_);
    part.soup.vertex_ids = ids(soup_.vertex_ids, vertices);
    part.soup.face_ids = ids(soup_.face_ids, faces);
    part.soup.missing = missing(faces);
    part.soup.groups = groups(faces);
    set_normals(faces, vertices, rest, part.soup);
    return part;
  }

 private:
  static std::vector<Index> records(std::span<const Triangle> lists, std::span<const Index> faces,
                                    Rest rest, std::size_t n_records) {
    std::vector<Index> used = used_by(lists, faces);
    if (rest == Rest::Leaves) return used;
    const std::vector<Index> unused = unused_by(lists, n_records);
    std::vector<Index> all;
    all.reserve(used.size() + unused.size());
    std::merge(used.begin(), used.end(), unused.begin(), unused.end(), std::back_inserter(all));
    return all;
  }

  static void number(std::span<const Index> records, std::vector<Index>& numbers) {
    for (std::size_t i = 0; i < records.size(); ++i) numbers[records[i]] = static_cast<Index>(i);
  }

  static std::vector<Triangle> renumbered(std::vector<Triangle> lists,
                                          const std::vector<Index>& numbers) {
    for (Triangle& list : lists) {
      for (Index& i : list) i = i == kNoIndex ? kNoIndex : numbers[i];
    }
    return lists;
  }

  /// Other formats number their records implicitly.
  Ids ids(const Ids& all, std::span<const Index> records) const {
    if (soup_.format != Format::Mesh || records.empty()) return {all.first, {}};
    std::vector<std::int32_t> kept;
    kept.reserve(records.size());
    for (const Index i : records) kept.push_back(static_cast<std::int32_t>(all.of(i)));
    return compact_ids(std::move(kept));
  }

  std::vector<MissingReference> missing(std::span<const Index> faces) const {
    std::vector<MissingReference> kept;
    if (soup_.missing.empty()) return kept;
    const auto less = [](const MissingReference& reference, Index face) {
      return reference.face < face;
    };
    for (std::size_t i = 0; i < faces.size(); ++i) {
      auto next = std::lower_bound(soup_.missing.begin(), soup_.missing.end(), faces[i], less);
      for (; next != soup_.missing.end() && next->face == faces[i]; ++next) {
        kept.push_back(*next);
        kept.back().face = static_cast<Index>(i);
      }
    }
    return kept;
  }

  std::vector<Group> groups(std::span<const Index> faces) const {
    std::vector<Group> kept;
    Index latest = kNoIndex;
    for (std::size_t i = 0; i < faces.size() && !soup_.groups.empty(); ++i) {
      const Index group = group_of(soup_, faces[i]);
      if (group != latest) kept.push_back({soup_.groups[group].name, static_cast<Index>(i)});
      latest = group;
    }
    return kept;
  }

  void set_normals(std::span<const Index> faces, std::span<const Index> vertices, Rest rest,
                   Soup& part) {
    if (has_vertex_normals_) {
      part.normals = picked(soup_.normals, vertices);
      part.corner_normals = part.triangles;
      return;
    }
    const std::span<const Index> named =
        soup_.corner_normals.empty() ? std::span<const Index>{} : faces;
    const std::vector<Index> normals =
        records(soup_.corner_normals, named, rest, soup_.normals.size());
    number(normals, new_normal_);
    part.normals = picked(soup_.normals, normals);
    part.corner_normals = renumbered(picked(soup_.corner_normals, named), new_normal_);
  }

  const TrackedMesh& tracked_;
  const Soup& soup_;
  /// The number of each record in the current part, if it is in it.
  std::vector<Index> new_vertex_;
  std::vector<Index> new_normal_;
  bool has_vertex_normals_;
};

}  // namespace

std::vector<TrackedMesh> separate(const TrackedMesh& tracked) {
  Parts parts = number_components(tracked.soup);
  if (parts.count <= 1) {
    return {tracked};
  }
  sort_by_size(tracked.soup, parts);
  const std::vector<std::vector<Index>> faces = faces_by_part(parts);
  Extractor extractor(tracked);
  std::vector<TrackedMesh> separated;
  separated.reserve(parts.count);
  for (std::size_t i = 0; i < parts.count; ++i) {
    separated.push_back(
        extractor.extract(faces[i], i == 0 ? Extractor::Rest::Takes : Extractor::Rest::Leaves));
  }
  return separated;
}

}  // namespace meshalyzer
