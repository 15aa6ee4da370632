#pragma once

#include "meshalyzer/arrangement/cells.h"
#include "meshalyzer/spatial/face_tree.h"

namespace meshalyzer {

/// A soup, its arrangement, and its cells. It only refers to them.
struct ArrangedSoup {
  const Soup& soup;
  const CutMesh& cut;
  /// The tree over the faces of `cut`.
  const FaceTree& tree;
  const Arrangement& arrangement;
  const Cells& cells;
};

}  // namespace meshalyzer
