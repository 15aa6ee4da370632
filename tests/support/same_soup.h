#pragma once

#include "meshalyzer/mesh/soup.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

namespace meshalyzer {

/// Tells whether two lists of vectors have the same bits: -0.0 differs from 0.0 here.
inline bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Vec3& p, const Vec3& q) {
    return std::memcmp(p.data(), q.data(), 3 * sizeof(double)) == 0;
  });
}

/// Tells whether two lists of `n` records have the same ids, however they are stored.
inline bool same_ids(const Ids& a, const Ids& b, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    if (a.of(static_cast<Index>(i)) != b.of(static_cast<Index>(i))) {
      return false;
    }
  }
  return true;
}

/// Tells whether two soups are the same mesh to the last bit. Lines, and the number of polygons
/// that were triangulated, may differ: they belong to the text, not to the mesh.
inline bool same_soup(const Soup& a, const Soup& b) {
  const auto same_group = [](const Group& g, const Group& h) {
    return g.name == h.name && g.first_face == h.first_face;
  };
  return a.format == b.format && same_bits(a.positions, b.positions) &&
         a.triangles == b.triangles && same_ids(a.vertex_ids, b.vertex_ids, a.n_vertices()) &&
         same_ids(a.face_ids, b.face_ids, a.n_faces()) && same_bits(a.normals, b.normals) &&
         a.corner_normals == b.corner_normals &&
         std::equal(a.groups.begin(), a.groups.end(), b.groups.begin(), b.groups.end(), same_group);
}

}  // namespace meshalyzer
