#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// The record of a file that an element of an edited mesh comes from.
struct ElementOrigin {
  enum class Relation : std::uint8_t {
    /// The element is that record, moved or changed perhaps.
    Same,
    /// The vertex is a copy of that vertex; the face was made of that face.
    MadeOf,
    /// The face is part of a hole patch, and lies beside that face.
    Beside,
    /// No record is like it.
    New,
  };
  Relation relation = Relation::New;
  /// kNoIndex where no record is like it.
  Index record = kNoIndex;
};

/// A mesh that was made of a file's, and where its elements come from. Only refers to the meshes.
struct EditedMesh {
  /// The mesh as it was read.
  const Soup& source;
  /// What became of it. Elements that are records of the source stand in the order of the source,
  /// added vertices behind all others.
  const Soup& soup;
  /// The origins by vertex and by face of `soup`.
  std::vector<ElementOrigin> vertices;
  std::vector<ElementOrigin> faces;
  /// Faces of the source of which something is left that lies on another face now, and counts as
  /// made of that.
  std::vector<Index> left_places = {};
};

}  // namespace meshalyzer
