#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <vector>

namespace meshalyzer {

/// A mesh under repair: always whole, and it knows where each of its elements comes from.
///
/// Elements have keys that outlive all changes: vertex and face records of the input are 0, 1, ...
/// in file order, what is added later goes on counting.
struct Draft {
  Soup soup;
  /// #V and #F, ascending within what was never moved in order.
  std::vector<Index> vertex_keys;
  std::vector<Index> face_keys;
  std::size_t n_input_vertices = 0;
  std::size_t n_input_faces = 0;
  /// By key - n_input_faces: the key of the input's face that an added face was made of; kNoIndex:
  /// it is part of a hole patch.
  std::vector<Index> face_origins;
  /// By key - n_input_vertices: the key of the input's vertex that an added vertex is a copy of;
  /// kNoIndex: it is new.
  std::vector<Index> vertex_origins;

  /// The input's face that the face at this place of the soup was made of, by index there; kNoIndex
  /// where it is part of a hole patch.
  [[nodiscard]] Index origin_of_face(Index face) const { return origin_of_key(face_keys[face]); }
  /// The same for a face by its key.
  [[nodiscard]] Index origin_of_key(Index key) const {
    return key < n_input_faces ? key : face_origins[key - n_input_faces];
  }
};

/// The draft that is the input itself.
[[nodiscard]] Draft make_draft(Soup soup);

}  // namespace meshalyzer
