#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// The record of a file that an element of an edited mesh comes from.
struct ElementOrigin {
  enum class Relation : std::uint8_t {
    /// The element is that record, possibly moved or changed.
    Same,
    /// The vertex is a copy of that vertex; the face was made from that face.
    MadeOf,
    /// The face is part of a hole patch, and lies beside that face.
    Beside,
    /// The element is new and has no record.
    New,
  };
  Relation relation = Relation::New;
  /// The record; kNoIndex if there is none.
  Index record = kNoIndex;
};

/// A mesh that was made from that of a file, and the origins of its elements. It only refers to the
/// meshes.
struct EditedMesh {
  /// The mesh as it was read.
  const Soup& source;
  /// The edited mesh. Elements that are records of the source keep their order; added vertices
  /// follow all others.
  const Soup& soup;
  /// The origins of the vertices, and of the faces, of `soup`.
  std::vector<ElementOrigin> vertices;
  std::vector<ElementOrigin> faces;
  /// The faces of the source whose remains lie on another face now, and count as made from that.
  std::vector<Index> left_places = {};
};

}  // namespace meshalyzer
