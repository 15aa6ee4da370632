#pragma once

#include "meshalyzer/spatial/face_tree.h"

#include <vector>

namespace meshalyzer {

/// Faces that all have one vertex in common, the hub, and the box of their other vertices, the rim.
struct Fan {
  /// The file vertex; kNoIndex if the faces have none in common.
  Index hub = kNoIndex;
  /// The box of the rim, in the tree's coordinates.
  TreeBox rim{};
};

/// Tells for each node of a FaceTree whether the faces below it are part of one fan.
///
/// Round a vertex with very many faces (the tip of a cone, the centre of a CAD facet) all boxes
/// contain that vertex, so boxes cull nothing; but two faces of a fan meet beyond the hub only if
/// the rim of one meets the other.
class FanTree {
 public:
  /// @complexity O(#F).
  explicit FanTree(const FaceTree& tree);

  /// Returns the fan of all faces below FaceTree::node(level, i).
  [[nodiscard]] const Fan& fan(std::size_t level, std::size_t i) const {
    return fans_[levels_[level][i]];
  }

  /// Tells whether the faces of two nodes meet only at the hub that all of them share.
  ///
  /// It is false for nodes whose faces have an edge in common: its other end is on the rim of both.
  [[nodiscard]] static bool meet_at_hub_only(const Fan& a, const TreeBox& box_a, const Fan& b,
                                             const TreeBox& box_b);

 private:
  void add_leaves(const FaceTree& tree);
  /// Adds the nodes one level above the highest so far.
  void add_level();

  /// The number of each node's fan in `fans_`, in four bytes, since hardly any leaf of most meshes
  /// is one.
  std::vector<std::vector<Index>> levels_;
  /// The first is that of the nodes whose faces have no vertex in common.
  std::vector<Fan> fans_{Fan{}};
};

}  // namespace meshalyzer
