#pragma once

#include "meshalyzer/mesh/inner_halfedge.h"
#include "meshalyzer/mesh/side_table.h"

#include <cstddef>
#include <vector>

namespace meshalyzer {

/// A partition of the faces of a complex into components.
struct Components {
  std::size_t count = 0;
  /// #mesh faces: the component of each, 0 ... count - 1, numbered in order of their lowest face.
  std::vector<Index> of_face;

  [[nodiscard]] Index of(FaceHandle face) const {
    return of_face[static_cast<std::size_t>(face.idx())];
  }
  /// Returns the component of an edge, which has a face, by one of its half-edges.
  [[nodiscard]] Index of(const TriMesh& mesh, HalfedgeHandle halfedge) const {
    return of(mesh.face_handle(inner_halfedge(mesh, halfedge)));
  }
};

/// Finds the components connected through shared file vertices: the separate objects in a file.
///
/// @complexity O(#E log #F) time, near linear in practice; one index a face of temporary memory.
[[nodiscard]] Components find_components(const CutMesh& cut);

/// Finds the components connected through shared edges of the complex, including flipped and
/// non-manifold edges.
///
/// @complexity O(#E log #F) time, near linear in practice; one index a face of temporary memory.
[[nodiscard]] Components find_edge_components(const CutMesh& cut);

/// Finds the components of the cut mesh, which are connected through edges with two faces that
/// cross them in opposite directions. Each is consistently oriented.
///
/// @complexity The same as that of find_edge_components().
[[nodiscard]] Components find_oriented_regions(const CutMesh& cut);

/// Returns the component of each file face, kNoIndex for faces that are not in the complex.
///
/// @param n_file_faces  The number of faces of the soup that the cut mesh was built from.
[[nodiscard]] std::vector<Index> components_of_file_faces(const CutMesh& cut,
                                                          const Components& components,
                                                          std::size_t n_file_faces);

}  // namespace meshalyzer
