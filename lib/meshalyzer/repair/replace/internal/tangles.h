#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// Places where a mesh intersects itself, and the rest of it.
struct Tangles {
  /// #places: their faces, by index into the soup, ascending. No two have a vertex in common.
  std::vector<std::vector<Index>> places;
  /// The mesh without these faces, and without those that are refilled already; their records name
  /// no vertices, so that all others keep their index. It is empty if there are no places.
  Soup rest;
};

/// Which places are found.
struct TangleLimits {
  /// The number of rings of faces that are taken from round the intersecting ones.
  std::size_t n_rings = 0;
  /// Places with more faces are left out, and so are those of several components, and whole
  /// components.
  std::size_t max_faces = 0;
};

/// Finds the places where parts of a mesh intersect themselves, each with the faces round it, and
/// with the small parts of the surface that these cut off from the rest of their component.
///
/// @param refilled  The faces of places that are refilled already: no place has a vertex of them.
/// @return          The places in order of their lowest face.
/// @complexity      O(#F log #F), and that of PreparedMesh::intersecting_pairs().
[[nodiscard]] Tangles find_tangles(const PreparedMesh& mesh, const TangleLimits& limits,
                                   std::span<const Index> refilled = {});

}  // namespace meshalyzer
