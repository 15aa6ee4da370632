#pragma once

#include "meshalyzer/arrangement/cells.h"
#include "meshalyzer/spatial/face_tree.h"

#include <span>

namespace meshalyzer {

/// A soup, its arrangement, and its cells. It only refers to them.
struct ArrangedSoup {
  const Soup& soup;
  const CutMesh& cut;
  /// The tree over the faces of `cut`.
  const FaceTree& tree;
  const Arrangement& arrangement;
  const Cells& cells;

  /// Returns the component of the pieces of a face; kNoIndex if it has none, as a face of no area
  /// often has.
  [[nodiscard]] Index component_of_face(Index face) const {
    const std::span<const Index> pieces = arrangement.pieces_of(face);
    return pieces.empty() ? kNoIndex : cells.component_of[pieces[0]];
  }
};

}  // namespace meshalyzer
