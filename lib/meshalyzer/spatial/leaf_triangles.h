#pragma once

#include "meshalyzer/spatial/face_tree.h"

#include <array>
#include <cstddef>

namespace meshalyzer {

/// The corners of the faces of one leaf of a FaceTree side by side, in the tree's coordinates.
/// Leaves with fewer than eight faces repeat the last.
struct LeafTriangles {
  /// The coordinates, by corner, coordinate, and face.
  alignas(16) std::array<std::array<std::array<float, 8>, 3>, 3> corners;

  LeafTriangles() = default;
  LeafTriangles(const FaceTree& tree, std::size_t leaf);
};

}  // namespace meshalyzer
