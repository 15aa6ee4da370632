#pragma once

#include "meshalyzer/arrangement/cells.h"
#include "meshalyzer/spatial/face_tree.h"

namespace meshalyzer {

/// What an arrangement was made of, and its cells. Only refers.
struct ArrangedSoup {
  const Soup& soup;
  const CutMesh& cut;
  /// Over the faces of `cut`.
  const FaceTree& tree;
  const Arrangement& arrangement;
  const Cells& cells;
};

}  // namespace meshalyzer
