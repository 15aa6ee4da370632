#pragma once

#include "support/edited_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

namespace meshalyzer {

/// Returns the first vertex that has the id of this one: only this one can a face name in a file.
inline Index first_of_its_id(const Soup& soup, Index vertex) {
  const auto& ids = soup.vertex_ids.named;
  if (ids.empty()) return vertex;
  return static_cast<Index>(std::find(ids.begin(), ids.end(), ids[vertex]) - ids.begin());
}

/// Edits a file as a repair might, a few times; `next` returns numbers below its argument.
inline void edit_at_random(EditedFile& file, const std::function<Index(std::size_t)>& next) {
  const std::size_t n_records = file.soup().n_faces();
  for (Index i = next(6); i > 0 && file.soup().n_faces() > 1; --i) {
    Soup& soup = file.soup();
    const Index face = next(soup.n_faces());
    const Index vertex = first_of_its_id(soup, next(soup.n_vertices()));
    switch (next(6)) {
      case 0:
        soup.positions[vertex].x() += 0.5;
        break;
      case 1:
        file.drop_face(face);
        break;
      case 2:
        for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
        break;
      case 3:
        soup.triangles[face][next(3)] = vertex;
        break;
      case 4:
        file.add_vertex(soup.positions[vertex] + Vec3(0.25, 0, 0));
        file.add_face({soup.triangles[face][0], soup.triangles[face][1],
                       static_cast<Index>(soup.n_vertices() - 1)},
                      made_of(next(n_records)));
        break;
      default:
        file.add_face({soup.triangles[face][0], soup.triangles[face][2], vertex},
                      beside(next(n_records)));
    }
  }
  file.drop_unused_vertices();
}

/// Tells whether two faces have the same corners by position, in the same direction.
inline bool is_same_face(std::array<Vec3, 3> a, const std::array<Vec3, 3>& b) {
  for (int turn = 0; turn < 3; ++turn) {
    if (a == b) return true;
    a = {a[1], a[2], a[0]};
  }
  return false;
}

/// Tells whether an edited file, read again, is the mesh that was written: every face where the
/// file says that it is and, except in STL, every vertex in its order.
inline bool says_what_was_written(EditedFile& file, const RewrittenFile& written,
                                  const Soup& read) {
  const Soup& soup = file.soup();
  if (read.n_faces() != soup.n_faces()) return false;
  if (read.format != Format::Stl && read.positions != soup.positions) return false;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const Index on_file = written.file_faces.empty() ? f : written.file_faces[f];
    if (!is_same_face(corners_of(read, on_file), corners_of(soup, f))) return false;
  }
  return true;
}

}  // namespace meshalyzer
