#pragma once

#include "meshalyzer/spatial/face_tree.h"

#include <array>
#include <atomic>
#include <vector>

namespace meshalyzer {

/// The corners of the faces of one leaf of a FaceTree, coordinate by coordinate, in the tree's
/// coordinates.
///
/// Leaves with fewer than eight faces repeat one of them.
struct LeafCorners {
  static constexpr std::size_t kCorners = 24;
  std::array<std::array<float, kCorners>, 3> coordinates;

  LeafCorners(const FaceTree& tree, std::size_t leaf);
};

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

  /// Tells whether all corners surely lie on one side of one of the slabs, so that no face of the
  /// leaf meets the bundle.
  [[nodiscard]] bool exclude(const LeafCorners& corners) const;
};

/// Oriented slabs for those nodes of a FaceTree that axis-aligned boxes fit badly: bundles of long
/// faces oblique to the axes, millions of whose boxes meet although the faces are far apart.
class SlabTree {
 public:
  /// @complexity O(#F) if no node is such a bundle, else O(#F log #F).
  explicit SlabTree(const FaceTree& tree);

  /// Returns the slabs of all faces below FaceTree::node(level, i).
  [[nodiscard]] const Slabs& slabs(std::size_t level, std::size_t i) const {
    return levels_[level][i];
  }
  /// Tells whether any node has slabs worth a test.
  [[nodiscard]] bool has_useful() const { return has_useful_; }

 private:
  std::vector<std::vector<Slabs>> levels_;
  std::atomic<bool> has_useful_ = false;
};

}  // namespace meshalyzer
