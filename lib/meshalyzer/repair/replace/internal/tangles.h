#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"

#include <cstddef>
#include <vector>

namespace meshalyzer {

/// Places where a mesh intersects itself, and the rest of it.
struct Tangles {
  /// #places: their faces, by index into the soup, ascending. No two have a vertex in common.
  std::vector<std::vector<Index>> places;
  /// The mesh without these faces; their records name no vertices, so that all others keep their
  /// index. It is empty if there are no places.
  Soup rest;
};

/// Finds the places where parts of a mesh intersect themselves, each with the faces round it, and
/// with the small parts of the surface that these cut off from the rest of their component.
///
/// @param n_rings    The number of rings of faces that are taken from round the intersecting ones.
/// @param max_faces  Places with more faces are left out, and so are those of several components,
///                   and whole components.
/// @return           The places in order of their lowest face.
/// @complexity       O(#F log #F), and that of PreparedMesh::intersecting_pairs().
[[nodiscard]] Tangles find_tangles(const PreparedMesh& mesh, std::size_t n_rings,
                                   std::size_t max_faces);

}  // namespace meshalyzer
