#pragma once

#include "meshalyzer/mesh/soup.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace meshalyzer {

/// A mesh under repair that records where each of its elements comes from.
///
/// Elements have keys that outlive all changes: the vertex and face records of the input have 0, 1,
/// ... in file order, and elements added later continue the numbering.
struct TrackedMesh {
  Soup soup;
  /// The keys of vertices and faces; ascending unless elements were reordered.
  std::vector<Index> vertex_keys;
  std::vector<Index> face_keys;
  std::size_t n_input_vertices = 0;
  std::size_t n_input_faces = 0;
  /// The key of the input's face that each added face was made of, indexed by key - n_input_faces;
  /// kNoIndex where it is part of a hole patch.
  std::vector<Index> face_origins;
  /// The key of the input's vertex that each added vertex is a copy of, indexed by key -
  /// n_input_vertices; kNoIndex where it is new.
  std::vector<Index> vertex_origins;
  /// The keys of the vertices that lie where sheets were cut, and of their copies; ascending.
  std::vector<Index> sheet_cuts;

  /// Tells whether a vertex of the soup lies where a sheet was cut.
  [[nodiscard]] bool is_where_sheet_was_cut(Index vertex) const {
    return std::binary_search(sheet_cuts.begin(), sheet_cuts.end(), vertex_keys[vertex]);
  }

  /// Tells whether both vertices of an edge lie where a sheet was cut.
  [[nodiscard]] bool is_where_sheet_was_cut(Index a, Index b) const {
    return is_where_sheet_was_cut(a) && is_where_sheet_was_cut(b);
  }

  /// Returns the input's face that a face of the soup was made of; kNoIndex where it is part of a
  /// hole patch.
  [[nodiscard]] Index origin_of_face(Index face) const { return origin_of_key(face_keys[face]); }
  /// Does the same for a face by its key.
  [[nodiscard]] Index origin_of_key(Index key) const {
    return key < n_input_faces ? key : face_origins[key - n_input_faces];
  }

  /// Returns the key of the input's vertex that a vertex, by its key, is or is a copy of; kNoIndex
  /// where it is new.
  [[nodiscard]] Index origin_of_vertex_key(Index key) const {
    return key < n_input_vertices ? key : vertex_origins[key - n_input_vertices];
  }

  /// Returns the number of keys that vertices have had since the input.
  [[nodiscard]] std::size_t n_vertex_keys() const {
    return n_input_vertices + vertex_origins.size();
  }
  /// Returns the same for faces.
  [[nodiscard]] std::size_t n_face_keys() const { return n_input_faces + face_origins.size(); }
};

/// Starts to track a mesh: the result is the input, with keys.
///
/// @throws InvalidArgument  if the soup contradicts itself.
[[nodiscard]] TrackedMesh track_mesh(Soup soup);

}  // namespace meshalyzer
