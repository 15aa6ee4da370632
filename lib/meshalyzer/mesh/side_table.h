#pragma once

#include "meshalyzer/mesh/tri_mesh.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// An edge of the file's complex that the half-edge mesh holds as several border edges.
struct CutEdge {
  /// One inner half-edge (the one that has a face) for each face at the edge, in order of the
  /// file's faces.
  std::span<const HalfedgeHandle> halfedges;
};

/// A list of cut edges, stored in one array.
struct CutEdges {
  /// #edges + 1: where each edge's half-edges begin in `halfedges`.
  std::vector<Index> begin{0};
  std::vector<HalfedgeHandle> halfedges;

  [[nodiscard]] std::size_t size() const { return begin.size() - 1; }
  [[nodiscard]] CutEdge operator[](std::size_t i) const {
    return {std::span(halfedges).subspan(begin[i], begin[i + 1] - begin[i])};
  }
};

/// Describes how the pieces of the cut mesh belong together, which the half-edge mesh cannot hold.
///
/// Two mesh vertices are copies of one file vertex exactly when vertex() is the same for both. Mesh
/// and table together are the file's complex, nothing more and nothing less: see unbuild() and
/// validate().
struct SideTable {
  /// The number of vertex records of the file: mesh vertices 0 ... n_file_vertices - 1 are these,
  /// in file order.
  std::size_t n_file_vertices = 0;
  /// The file vertex of mesh vertex n_file_vertices + i, for each copy that cutting made, in order
  /// of their file vertices.
  std::vector<Index> copies;
  /// #mesh faces: the index of each in the file, ascending.
  std::vector<Index> faces;
  /// The faces of the file that no half-edge mesh can hold, because they name a vertex twice or an
  /// undefined one. Ascending.
  std::vector<Index> rejected_faces;
  /// Edges with more than two faces, in order of their two file vertices (smaller first).
  CutEdges non_manifold_edges;
  /// Edges with exactly two faces, both of which cross it in the same direction, in the same order.
  CutEdges flipped_edges;
  /// File vertices whose faces are not one fan (faces joined through two-face edges, whichever way
  /// they are oriented), the ends of non-manifold edges included. Ascending.
  std::vector<Index> non_manifold_vertices;

  /// Returns the file vertex that a mesh vertex is, or is a copy of.
  [[nodiscard]] Index vertex(VertexHandle v) const {
    const auto i = static_cast<Index>(v.idx());
    return i < n_file_vertices ? i : copies[i - n_file_vertices];
  }
  /// Returns the mesh vertices into which a file vertex was cut: itself, then its copies.
  ///
  /// @complexity O(log #copies + what is returned).
  [[nodiscard]] std::vector<VertexHandle> mesh_vertices(Index file_vertex) const {
    std::vector<VertexHandle> vertices{VertexHandle(static_cast<int>(file_vertex))};
    const auto [first, last] = std::equal_range(copies.begin(), copies.end(), file_vertex);
    for (auto copy = first; copy != last; ++copy) {
      const auto number = static_cast<std::size_t>(copy - copies.begin());
      vertices.emplace_back(static_cast<int>(n_file_vertices + number));
    }
    return vertices;
  }

  /// Returns the file face that a mesh face is.
  [[nodiscard]] Index face(FaceHandle f) const { return faces[static_cast<std::size_t>(f.idx())]; }
  /// Returns the index of the mesh face that is this face of the file, which must not be a rejected
  /// one.
  [[nodiscard]] std::size_t mesh_face(Index file_face) const {
    // As long as no face before it was rejected, no search is needed.
    if (file_face < faces.size() && faces[file_face] == file_face) return file_face;
    return static_cast<std::size_t>(std::lower_bound(faces.begin(), faces.end(), file_face) -
                                    faces.begin());
  }
};

/// A file's complex as a half-edge mesh, cut open wherever the complex is not a consistently
/// oriented 2-manifold, and the table that says how the pieces belong together.
struct CutMesh {
  TriMesh mesh;
  SideTable side;
};

}  // namespace meshalyzer
