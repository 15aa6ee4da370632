#pragma once

#include "meshalyzer/spatial/leaf_triangles.h"

#include <array>
#include <vector>

namespace meshalyzer {

/// Two slabs across the long side of a bundle of faces; all its corners lie in both.
struct Slabs {
  /// The unit normals of the slabs, in the tree's coordinates.
  std::array<std::array<float, 3>, 2> axis{};
  /// The lower bounds along each, widened by more than any rounding error.
  std::array<float, 2> low{};
  std::array<float, 2> high{};
  /// Tells whether the bundle is much thinner than its axis-aligned box; only then are the slabs
  /// worth a test.
  bool is_useful = false;

  /// Whether the faces are long and thin, so that they have a direction in common.
  [[nodiscard]] bool has_axes() const { return axis[0] != axis[1]; }

  /// Tells whether the corners of all faces of a leaf surely lie on one side of one of the slabs,
  /// so that none of them meets the bundle.
  [[nodiscard]] bool exclude(const LeafTriangles& faces) const;
};

/// Oriented slabs for those nodes of a FaceTree that axis-aligned boxes fit badly: bundles of long
/// faces oblique to the axes, millions of whose boxes meet although the faces are far apart.
class SlabTree {
 public:
  /// @complexity O(#F) time and no memory if no node is such a bundle, else O(#F log #F) time and
  ///             some 45 bytes a face.
  explicit SlabTree(const FaceTree& tree);

  /// Tells whether any node has slabs worth a test.
  [[nodiscard]] bool has_useful() const { return !levels_.empty(); }

  /// Returns the slabs of all faces below FaceTree::node(level, i).
  ///
  /// @pre has_useful()
  [[nodiscard]] const Slabs& slabs(std::size_t level, std::size_t i) const {
    return levels_[level][i];
  }

  /// Returns the faces of a leaf, whose corners are kept because very many leaves are compared with
  /// each.
  ///
  /// @pre has_useful()
  [[nodiscard]] const LeafTriangles& triangles(std::size_t leaf) const { return triangles_[leaf]; }

 private:
  /// Makes the slabs of the nodes one level above the highest so far.
  void add_level(const FaceTree& tree);

  void keep_triangles(const FaceTree& tree);

  std::vector<std::vector<Slabs>> levels_;
  /// #leaves.
  std::vector<LeafTriangles> triangles_;
};

}  // namespace meshalyzer
